// The program: a thin shell around the library.
#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <exception>
#include <iostream>
#include <sstream>

#include "cli/command.hpp"
#include "input/diagnostic.hpp"
#include "output/output_error.hpp"

namespace {

/// No file that is opened later takes the place of a standard stream that whoever started the program has closed: a
/// result would be written into it. What stands there instead can be opened, and neither read nor written.
void keep_standard_streams_apart() {
  while (true) {
    const int unusable = open("/", O_PATH);
    if (unusable > 2) {
      close(unusable);
      return;
    }
    if (unusable < 0) return;
  }
}

int run(int argc, char** argv) {
  using namespace slipproof;
  CLI::App app("Exact, provable answers about dry friction", "slipproof");
  app.set_version_flag("--version", "slipproof " SLIPPROOF_VERSION);
  app.require_subcommand(1);
  int exit_code = cli::as_it_should_be;
  cli::add_solve(app, exit_code);
  cli::add_show(app, exit_code);
  cli::add_search(app, exit_code);
  cli::add_critical(app, exit_code);
  cli::add_certify(app, exit_code);
  cli::add_trade(app, exit_code);
  cli::add_verify(app, exit_code);
  cli::add_prove(app, exit_code);
  cli::add_check(app, exit_code);
  cli::add_report(app, exit_code);
  cli::add_map(app, exit_code);
  cli::add_draw(app, exit_code);
  cli::add_documentation(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream out;
    exit_code = app.exit(error, out) == 0 ? cli::as_it_should_be : cli::usage;
    cli::print(out.str());
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace slipproof;
  keep_standard_streams_apart();
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the limit is an error like any other
  try {
    return run(argc, argv);
  } catch (const InputError& error) {
    std::cerr << error.what() << '\n';
    return cli::bad_input;
  } catch (const OutputError& error) {
    std::cerr << error.what() << '\n';
    return cli::not_written;
  } catch (const std::exception& error) {
    std::cerr << "slipproof: " << error.what() << '\n';
    return cli::refuted_or_not_certified;
  }
}
