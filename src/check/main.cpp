// slipproof-check CERT|FOLDER...: checks certificates against the statements beside them.
// Exit codes: 0 all accepted, 2 usage, 3 a file cannot be read or a statement is malformed, 5 a certificate is
// rejected.
#include <iostream>
#include <string_view>

#include "check/files.hpp"

int main(int argc, char** argv) {
  using slipproof::check::Verdict;
  if (argc < 2 || std::string_view(argv[1]).starts_with("-")) {
    std::cerr << "usage: slipproof-check CERT|FOLDER...\n";
    return argc == 2 && std::string_view(argv[1]) == "--help" ? 0 : 2;
  }
  int accepted = 0;
  int rejected = 0;
  int unreadable = 0;
  for (int i = 1; i < argc; ++i) {
    const auto certificates = slipproof::check::certificates_in(argv[i]);
    if (certificates.empty()) {
      std::cout << "unreadable " << argv[i] << ": no statements in this folder\n";
      ++unreadable;
    }
    for (const auto& certificate : certificates) {
      const auto result = slipproof::check::check_file(certificate);
      if (result.verdict == Verdict::accepted) {
        ++accepted;
        std::cout << "accepted " << result.theorem << '\n';
      } else {
        ++(result.verdict == Verdict::rejected ? rejected : unreadable);
        std::cout << (result.verdict == Verdict::rejected ? "rejected " : "unreadable ") << result.message << '\n';
      }
    }
  }
  std::cout << (rejected > 0     ? "s REJECTED "
                : unreadable > 0 ? "s UNREADABLE "
                                 : "s ACCEPTED ")
            << accepted << " accepted, " << rejected << " rejected, " << unreadable << " unreadable\n";
  return rejected > 0 ? 5 : unreadable > 0 ? 3 : 0;
}
