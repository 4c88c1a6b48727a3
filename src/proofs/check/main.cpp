// slipproof-check CERT|STATEMENT|FOLDER...: checks certificates against the statements in their folders. Exit codes:
// those of Report::exit_code, 2 for wrong usage, 6 if the result cannot be written, and 70 if the program itself fails.
#include <iostream>

#include "proofs/check/files.hpp"

int main(int argc, char** argv) try {
  const std::string first = argc > 1 ? argv[1] : "-";
  const bool asks = argc == 2 && (first == "--help" || first == "--version");
  if (first.starts_with("-") && !asks) {
    std::cerr << "usage: slipproof-check CERT|STATEMENT|FOLDER...\n";
    return 2;
  }
  int exit_code = 0;
  if (asks) {
    std::cout << (first == "--help" ? "usage: slipproof-check CERT|STATEMENT|FOLDER...\n"
                                    : "slipproof-check " SLIPPROOF_VERSION "\n");
  } else {
    const auto report = slipproof::check::check_files({argv + 1, argv + argc});
    std::cout << report.text << report.summary;
    exit_code = report.exit_code;
  }
  if (std::cout.flush()) return exit_code;
  std::cerr << "slipproof-check: standard output cannot be written\n";
  return 6;
} catch (const std::exception& error) {
  std::cerr << "slipproof-check: the program failed: " << error.what() << "; please report this\n";
  return 70;
}
