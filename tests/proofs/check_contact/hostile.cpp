// Hostile folders (support/files/hostile_files.hpp), of which slipproof-check-contact gets the certificates, or another
// program for the same format, which SLIPPROOF_CHECKER names.
#include "proofs/check_contact/examples.hpp"
#include "support/files/hostile_files.hpp"

using namespace slipproof::test;

namespace {

std::string checker() {
  const char* other = std::getenv("SLIPPROOF_CHECKER");
  return other != nullptr ? other : SLIPPROOF_BINARY_DIR "/slipproof-check-contact";
}

}  // namespace

TEST_CASE("hostile files: one verdict for each certificate, their counts, and an end") {
  for (const HostileCase& hostile : hostile_cases()) {
    CAPTURE(hostile.what);
    const HostileFolder folder({"", slipproof::check_contact::kRod});
    hostile.make(folder);
    std::vector<std::string> paths, expected;
    for (const Hostile& one : hostile.found) {
      paths.push_back((folder.path() / one.certificate).string());
      expected.push_back(one.alone);
    }
    const ProgramEnd outcome = run_checker(checker(), paths);
    CAPTURE(outcome.out);
    const ProgramEnd end = expected_end(expected);
    CHECK(outcome.exit_code == end.exit_code);
    CHECK(outcome.out.ends_with("\n" + end.out));
    // Of what is accepted a line more says what is established.
    const auto accepted = std::count(expected.begin(), expected.end(), "accepted");
    check_lines(outcome.out, expected.size() + static_cast<std::size_t>(accepted) + 1);
    for (std::size_t i = 0; i < expected.size() && expected.size() > 1; ++i) {
      const std::string says = ": " + expected[i] + (expected[i] == "accepted" ? "\n" : ": ");
      CHECK(outcome.out.find(says) != std::string::npos);
    }
  }
}
