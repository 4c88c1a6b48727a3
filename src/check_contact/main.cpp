// slipproof-check-contact FILE...: checks certificates about contact problems; `-` is standard input. Exit codes: those
// of ContactReport::exit_code, 2 for wrong usage, 6 where the result cannot be written, and 70 where
// the program itself fails.
#include <iostream>

#include "check_contact/files.hpp"

int main(int argc, char** argv) try {
  const std::string first = argc > 1 ? argv[1] : "--";
  const bool asks = argc == 2 && (first == "--help" || first == "--version");
  if (first.starts_with("-") && first != "-" && !asks) {
    std::cerr << "usage: slipproof-check-contact FILE...\n";
    return 2;
  }
  int exit_code = 0;
  if (asks) {
    std::cout << (first == "--help" ? "usage: slipproof-check-contact FILE...\n"
                                    : "slipproof-check-contact " SLIPPROOF_VERSION "\n");
  } else {
    const auto report = slipproof::check_contact::check_contact_files({argv + 1, argv + argc});
    std::cout << report.text << report.summary;
    exit_code = report.exit_code;
  }
  if (std::cout.flush()) return exit_code;
  std::cerr << "slipproof-check-contact: standard output cannot be written\n";
  return 6;
} catch (const std::exception& error) {
  std::cerr << "slipproof-check-contact: " << error.what() << '\n';
  return 70;
}
