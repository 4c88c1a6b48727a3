// slipproof-check CERT|FOLDER...: checks certificates against the statements beside them. Exit codes: those of
// Report::exit_code, and 2 for wrong usage.
#include <iostream>

#include "check/files.hpp"

int main(int argc, char** argv) try {
  if (argc < 2 || argv[1][0] == '-') {
    std::cerr << "usage: slipproof-check CERT|FOLDER...\n";
    return argc == 2 && std::string(argv[1]) == "--help" ? 0 : 2;
  }
  const auto report = slipproof::check::check_files({argv + 1, argv + argc});
  std::cout << report.text << report.summary;
  return report.exit_code;
} catch (const std::exception& error) {  // a folder that cannot be listed
  std::cerr << error.what() << '\n';
  return 3;
}
