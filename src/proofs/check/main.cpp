// slipproof-check CERT|STATEMENT|THEOREMS|FOLDER...: checks certificates against the statements in their folders or
// theorem files. `--show NAME THEOREMS` prints a part of such a file. Exit codes: those of Report::exit_code, 2 for
// wrong usage, 3 if there is no such part, 6 if the result cannot be written, and 70 if the program itself fails.
#include <iostream>

#include "proofs/check/files.hpp"

namespace {

constexpr const char* usage =
    "usage: slipproof-check CERT|STATEMENT|THEOREMS|FOLDER...\n"
    "       slipproof-check --show NAME[.statement|.cert] THEOREMS\n";

int run(const std::vector<std::string>& arguments) {
  const std::string first = arguments.empty() ? "-" : arguments.front();
  if (first == "--show" && arguments.size() == 3) {
    const auto part = slipproof::check::show_part(arguments[1], arguments[2]);
    std::cout << part.text;
    if (!part.problem.empty()) std::cerr << part.problem << '\n';
    return part.problem.empty() ? 0 : 3;
  }
  if (arguments.size() == 1 && first == "--help") std::cout << usage;
  if (arguments.size() == 1 && first == "--version") std::cout << "slipproof-check " SLIPPROOF_VERSION "\n";
  if (arguments.size() == 1 && (first == "--help" || first == "--version")) return 0;
  if (first.starts_with("-")) {
    std::cerr << usage;
    return 2;
  }
  const auto report = slipproof::check::check_files(arguments);
  std::cout << report.text << report.summary;
  return report.exit_code;
}

}  // namespace

int main(int argc, char** argv) try {
  const int exit_code = run({argv + 1, argv + argc});
  if (std::cout.flush()) return exit_code;
  std::cerr << "slipproof-check: standard output cannot be written\n";
  return 6;
} catch (const std::exception& error) {
  std::cerr << "slipproof-check: the program failed: " << error.what() << "; please report this\n";
  return 70;
}
