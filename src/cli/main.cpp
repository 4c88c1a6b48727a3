// The program: a thin shell around the library.
#include <exception>
#include <iostream>

#include "cli/command.hpp"
#include "input/diagnostic.hpp"

int main(int argc, char** argv) {
  using namespace slipproof;
  CLI::App app("Exact, provable answers about dry friction", "slipproof");
  app.set_version_flag("--version", "slipproof " SLIPPROOF_VERSION);
  app.require_subcommand(1);
  int exit_code = cli::as_it_should_be;
  cli::add_solve(app, exit_code);
  cli::add_certify(app, exit_code);
  cli::add_trade(app, exit_code);
  cli::add_verify(app, exit_code);
  cli::add_prove(app, exit_code);
  cli::add_check(app, exit_code);
  cli::add_report(app, exit_code);
  cli::add_map(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? cli::as_it_should_be : cli::usage;
  } catch (const InputError& error) {
    std::cerr << error.what() << '\n';
    return cli::bad_input;
  } catch (const std::exception& error) {
    std::cerr << "slipproof: " << error.what() << '\n';
    return cli::refuted_or_not_certified;
  }
  return exit_code;
}
