#include "faces/cli/program.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "base/input/near_match.hpp"
#include "base/number/effort.hpp"
#include "base/os/registers.hpp"
#include "base/output/listed.hpp"
#include "base/output/output_error.hpp"
#include "base/output/terminal.hpp"
#include "base/parallel/failure.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/crew_run.hpp"
#include "faces/cli/help.hpp"
#include "faces/cli/interrupt.hpp"
#include "mechanics/mechanism/names.hpp"

namespace slipproof::cli {

namespace {

/// Prevents files that are opened later from taking the place of a standard stream that the caller has closed: results
/// would be written into them. The placeholder can be opened, but neither read nor written.
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

/// Refuses commands that every rank would run completely.
void refuse_alone(CLI::App& app, const std::vector<std::string>& shared) {
  for (CLI::App* command : app.get_subcommands({})) {
    if (std::ranges::find(shared, command->get_name()) != shared.end()) continue;
    command->preparse_callback([command](std::size_t) {
      throw CLI::ValidationError(command->get_name(),
                                 "found more than one rank, expected one: this command runs on one rank only");
    });
  }
}

/// Proposes the command that somebody may have meant. CLI11 only says that the word was not expected.
void refuse_unknown_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  const std::string word = argv[1];
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == word) return;
    if (!command->get_group().empty()) names.push_back(command->get_name());
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  const auto meant = near_match(word, known);
  throw CLI::ValidationError(
      "unknown command '" + word + "'",
      (meant ? "did you mean '" + std::string(*meant) + "'? " : "") + "expected one of " + listed(names));
}

/// What is said of the first option that a command does not have; empty if all are known.
std::string unknown_option(const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands()) {
    std::vector<std::string> names;
    const auto add = [&](const CLI::App* one) {
      for (const CLI::Option* option : one->get_options({})) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
      }
    };
    add(command);
    for (const CLI::App* group : command->get_subcommands({})) add(group);
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    for (const std::string& word : command->remaining()) {
      if (word.starts_with("--")) return unknown_name("option", word, {names.begin(), names.end()});
    }
  }
  return {};
}

std::string exit_codes_text() {
  std::string text = "Exit codes:";
  for (const auto& [code, meaning] : exit_codes) text += "\n" + std::to_string(code) + ": " + std::string(meaning);
  return text;
}

/// To standard error; on a terminal in lines of 80 columns.
void complain(const std::string& message) {
  std::cerr << (is_terminal(STDERR_FILENO) ? narrow(message) : message + '\n');
}

int run_command(int argc, char** argv) {
  CLI::App app("Exact, provable answers about dry friction", "slipproof");
  app.set_version_flag("--version", "slipproof " SLIPPROOF_VERSION);
  app.require_subcommand(1);
  app.footer(exit_codes_text());
  app.formatter(help_formatter());
  int exit_code = success;
  add_solve(app, exit_code);
  add_rest(app, exit_code);
  add_impact(app, exit_code);
  add_show(app, exit_code);
  add_expect(app, exit_code);
  add_exchange(app, exit_code);
  add_search(app, exit_code);
  add_critical(app, exit_code);
  add_simulate(app, exit_code);
  add_certify(app, exit_code);
  add_trade(app, exit_code);
  add_verify(app, exit_code);
  add_prove(app, exit_code);
  add_check(app, exit_code);
  add_report(app, exit_code);
  add_map(app, exit_code);
  add_draw(app, exit_code);
  add_explore(app, exit_code);
  for (CLI::App* command : app.get_subcommands({})) group_options(*command);
  try {
    const Rank place = launched();
    if (place.rank != 0) be_silent();
    if (place.ranks > 1) refuse_alone(app, {"certify", "prove", "search", "trade", "verify"});
    refuse_unknown_command(app, argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (const std::string unknown = unknown_option(app); !unknown.empty()) {
      complain(unknown + "\nRun with --help for more information.");
      return usage;
    }
    std::ostringstream out;
    exit_code = app.exit(error, out) == 0 ? success : usage;
    print(out.str());
  }
  return exit_code;
}

/// The same, until Ctrl-C.
int run(int argc, char** argv) {
  Continuation continuation;
  try {
    const CtrlC ctrl_c;
    const StopScope scope(ctrl_c.token());
    return run_command(argc, argv);
  } catch (const Interrupted& interrupted) {
    continuation = interrupted.continuation();
  } catch (const Stopped&) {
    continuation.kept = "nothing is kept of it";
  }
  std::cerr << "slipproof: stopped by Ctrl-C; " << continuation.kept << "\nTo go on:\n  "
            << command_line({argv, argv + argc}, continuation) << '\n';
  CtrlC::end_program();
}

}  // namespace

int run_program(int argc, char** argv) {
  keep_standard_streams_apart();
  std::signal(SIGXFSZ, SIG_IGN);  // writing beyond the file size limit then fails with an ordinary error
  try {
    machine_registers();
  } catch (const std::invalid_argument& error) {
    std::cerr << "slipproof: " << error.what() << '\n';
    return usage;
  }
  return exit_code_of([&] { return run(argc, argv); });
}

int exit_code_of(const std::function<int()>& work) {
  try {
    return work();
  } catch (const InputError& error) {
    complain(error.what());
    return bad_input;
  } catch (const OutputError& error) {
    complain(error.what());
    return not_written;
  } catch (const TooMuchWork& error) {
    complain(std::string("slipproof: ") + error.what());
    return undecided;
  } catch (const std::filesystem::filesystem_error& error) {
    std::cerr << error.path1().string() << ": cannot be read: " << error.code().message() << '\n';
    return bad_input;
  } catch (const std::bad_alloc&) {
    std::cerr << "slipproof: there is not enough memory\n";
    return failed;
  } catch (const std::exception& error) {
    std::cerr << "slipproof: " << failure_text(error.what(), SLIPPROOF_VERSION) << '\n';
    return failed;
  } catch (...) {
    std::cerr << "slipproof: " << failure_text("an unknown exception", SLIPPROOF_VERSION) << '\n';
    return failed;
  }
}

}  // namespace slipproof::cli
