// The library's reading of theorem files: the same parts as the checker's, and each text again.
#include "proofs/statement/theorems.hpp"

#include <doctest/doctest.h>

#include "base/input/diagnostic.hpp"
#include "proofs/check/theorem_file.hpp"
#include "support/run_program.hpp"

using namespace slipproof;
using test::TemporaryFolder;

namespace {

const std::string kA = "slipproof-statement 1\ntheorem a\nreal x\nshow x = x\n";
const std::string kProof = "slipproof-certificate 1\nsome proof\n";
const std::string kClaims = "slipproof-claims 1\nclaim\n";

}  // namespace

TEST_CASE("a theorem file is written as it was read, and has the parts that the checker finds") {
  for (const char* paper : {"wedge", "small-friction", "rear-drive"}) {
    const std::filesystem::path path = std::string(SLIPPROOF_SOURCE_DIR "/proofs/") + paper + "/claims.theorems";
    const std::string text = test::read_file(path);
    const TheoremFile file = read_theorems(path);
    CHECK(file.text() == text);
    const check::TheoremFile checked = check::split_theorems(text);
    CHECK(checked.problem.empty());
    CHECK(checked.claims.text == file.claims);
    REQUIRE(checked.theorems.size() == file.theorems.size());
    for (const Theorem& theorem : file.theorems) {
      CHECK(checked.theorems.at(theorem.name).statement.text == theorem.statement);
      CHECK(checked.theorems.at(theorem.name).statement.line == theorem.line);
      CHECK(checked.theorems.at(theorem.name).certificate.text == theorem.certificate);
    }
  }
}

TEST_CASE("texts are found in theorem files and in folders alike") {
  const TemporaryFolder folder;
  folder.write("t.theorems", kClaims + kA + kProof);
  std::filesystem::create_directory(folder.path() / "old");
  folder.write("old/a.statement", kA);
  folder.write("old/a.cert", kProof);
  folder.write("old/claims.canonical", kClaims);
  TheoremTexts texts;
  for (const char* where : {"t.theorems", "old"}) {
    CAPTURE(where);
    const std::filesystem::path in = folder.path() / where;
    CHECK(texts.at(in / "a.statement") == kA);
    CHECK(texts.at(in / "a.cert") == kProof);
    CHECK(texts.at(in / canonical_name) == kClaims);
    CHECK_FALSE(texts.at(in / "b.statement"));
  }
  CHECK(texts.line_of(folder.path() / "t.theorems" / "a.statement") == 3);
  CHECK(texts.line_of(folder.path() / "old" / "a.statement") == 1);
  CHECK(file_of(folder.path() / "t.theorems" / "a.cert") == folder.path() / "t.theorems");
  CHECK(file_of(folder.path() / "old" / "a.cert") == folder.path() / "old" / "a.cert");
}

TEST_CASE("what is no theorem file is refused at its line") {
  const TemporaryFolder folder;
  const auto line = [&](const std::string& text) {
    try {
      read_theorems(folder.write("t.theorems", text));
    } catch (const InputError& error) {
      return error.diagnostics().at(0).line;
    }
    return std::size_t{0};
  };
  CHECK(line(kClaims + kA + kProof) == 0);
  CHECK(line("# of mine\n" + kA) == 1);
  CHECK(line(kClaims + kProof) == 3);
  CHECK(line(kA + kProof + kProof) == 7);
  CHECK(line(kA + kA) == 5);
  CHECK(line(kA + kClaims) == 5);
  CHECK(line("slipproof-statement 1\nreal x\n") == 1);
  CHECK_THROWS_AS(read_theorems(folder.path() / "none.theorems"), InputError);
}
