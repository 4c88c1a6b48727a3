// slipproof-check-contact [--problem NAME] FILE...: checks certificates about contact problems; `-` is standard input.
// Those about another problem than NAME are rejected. Exit codes: those of ContactReport::exit_code, 2 for wrong usage,
// 6 where the result cannot be written, and 70 where the program itself fails.
#include <iostream>

#include "proofs/check_contact/files.hpp"
#include "proofs/check_contact/reader.hpp"

namespace {

constexpr const char* kUsage = "usage: slipproof-check-contact [--problem NAME] FILE...\n";

int check(std::vector<std::string> arguments) {
  std::string required_name;
  if (arguments.size() >= 3 && arguments[0] == "--problem" && slipproof::check_contact::is_name(arguments[1])) {
    required_name = arguments[1];
    arguments.erase(arguments.begin(), arguments.begin() + 2);
  }
  if (arguments.empty() || (arguments[0].starts_with("-") && arguments[0] != "-")) {
    std::cerr << kUsage;
    return 2;
  }
  const auto report = slipproof::check_contact::check_contact_files(arguments, required_name);
  std::cout << report.text << report.summary;
  return report.exit_code;
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string first = argc == 2 ? argv[1] : "";
  int exit_code = 0;
  if (first == "--help") {
    std::cout << kUsage;
  } else if (first == "--version") {
    std::cout << "slipproof-check-contact " SLIPPROOF_VERSION "\n";
  } else {
    exit_code = check({argv + 1, argv + argc});
  }
  if (std::cout.flush()) return exit_code;
  std::cerr << "slipproof-check-contact: standard output cannot be written\n";
  return 6;
} catch (const std::exception& error) {
  std::cerr << "slipproof-check-contact: the program failed: " << error.what() << "; please report this\n";
  return 70;
}
