// The second reading confirms a fifth of the shipped certificates (soak: all) and what mutation has made of five of
// them, and refuses each proof with a step that is wrong.
#include "proofs/check/second_reading.hpp"

#include <doctest/doctest.h>

#include "proofs/check/examples.hpp"
#include "proofs/check/files.hpp"
#include "support/how_many.hpp"
#include "support/run_program.hpp"

namespace {

const std::filesystem::path kSecondProofs = SLIPPROOF_SOURCE_DIR "/proofs";

std::string second_answer(const std::string& statement, const std::string& proof) {
  return slipproof::test::unconfirmed(statement, slipproof::check::header(statement) + proof);
}

}  // namespace

TEST_CASE("the second reading confirms the shipped certificates") {
  const auto every = slipproof::test::how_many<std::size_t>("SLIPPROOF_SECOND_READING_EVERY", 15);
  const auto certificates = slipproof::check::certificates_in(kSecondProofs);
  CHECK(certificates.size() > 100 * 5);
  for (std::size_t i = 0; i < certificates.size(); i += every) {
    auto path = certificates[i];
    CAPTURE(path);
    const std::string certificate = slipproof::test::read_file(path);
    const std::string statement = slipproof::test::read_file(path.replace_extension(".statement"));
    CHECK(slipproof::test::unconfirmed(statement, certificate) == "");
  }
}

TEST_CASE("a mutant that is another proof of the same statement is accepted and confirmed") {
  struct Mutant {
    const char *certificate, *from, *to;
    int line;
  };
  for (const Mutant& mutant : std::vector<Mutant>{
           {"rear-drive/claims.theorems/T1.8", "have e3: -H*f + b + c > 0", "have e3: -H*f + b2+ c > 0", 25},
           {"rozenblat-yashin/claims.theorems/E2.5.backwards", "set a = 0", "set a =20", 13},
           {"rozenblat-yashin/claims.theorems/E2.6.repaired.backwards", "set a_y = 0", "set a_y = 3", 97},
           {"rozenblat-yashin/claims.theorems/E4.13.repaired.backwards", "term 1 e1 e2 e3", "term 1 force.1.3", 37},
           {"rozenblat-yashin/claims.theorems/R2.3.3", "have e11: b2*phi - g > 0", "have e11: b2*phi - g >=0", 21}}) {
    CAPTURE(std::string(mutant.certificate));
    const std::string name = (kSecondProofs / mutant.certificate).string();
    const std::string statement = slipproof::test::read_file(name + ".statement");
    std::istringstream lines(slipproof::test::read_file(name + ".cert"));
    std::string line, certificate;
    for (int number = 1; std::getline(lines, line); ++number) {
      if (number == mutant.line) CHECK(line == mutant.from);
      certificate += (number == mutant.line ? mutant.to : line) + '\n';
    }
    CHECK(slipproof::check::verdict(statement, certificate) == "");
    CHECK(slipproof::test::unconfirmed(statement, certificate) == "");
  }
}

TEST_CASE("the second reading refuses proofs that are wrong") {
  using slipproof::check::replaced;
  const std::string &split = slipproof::check::kSplitProof, &split_statement = slipproof::check::kSplitStatement;
  const std::string &witness = slipproof::check::kWitnessProof,
                    &witness_statement = slipproof::check::kWitnessStatement;
  CHECK(second_answer(split_statement, split) == "");
  CHECK(second_answer(witness_statement, witness) == "");
  const auto refuses = [](const std::string& answer, const std::string& because) {
    CAPTURE(answer);
    CAPTURE(because);
    CHECK(answer.find(because) != std::string::npos);
  };
  const std::string certificate = slipproof::check::header(split_statement) + split;
  refuses(slipproof::test::unconfirmed(replaced(split_statement, "t = x", "t = y"), certificate), "another statement");
  struct Change {
    const char *from, *to, *because;
  };
  for (const Change& change : std::vector<Change>{{"term 3 d.1", "term 2 d.1", "an identity does not hold"},
                                                  {"split r: x - y", "split r: y - x", "an identity does not hold"},
                                                  {"equation k: 3", "equation k: -3", "an identity does not hold"},
                                                  {"have k: t - x = 0", "have k: t - z = 0", "unknown name z"},
                                                  {"have k: t - x = 0", "have k: t 2 = 0", "two words"},
                                                  {"have k: t - x = 0", "have k: t - x = 1", "a comparison with 0"},
                                                  {"have k: t - x = 0", "have e: t - x = 0", "a second hypothesis e"},
                                                  {"equation k: 3", "equation d.1: 3", "d.1 is not an equation"},
                                                  {"term 3 d.1", "term 3 k", "k is not an inequality"},
                                                  {"term 1 d.2", "term 1 d.1", "no such hypothesis: d.1"},
                                                  {"cases d", "cases e", "no such hypothesis: e"},
                                                  {"branch 2\nsplit", "branch 3\nsplit", "the next branch"}}) {
    refuses(second_answer(split_statement, replaced(split, change.from, change.to)), change.because);
  }
  refuses(second_answer(witness_statement, replaced(witness, "set u = x/y", "set u = u")), "unknown name u");
  refuses(second_answer(witness_statement, replaced(witness, "set u = x/y", "set u = 2*x/y")),
          "an identity does not hold");
  refuses(second_answer(witness_statement, replaced(witness, "set u = x/y", "set u = x/0")), "division by zero");
  refuses(second_answer(split_statement, "cases goal\nend\n"), "other alternatives");
  const std::string weak = "slipproof-statement 1\ntheorem weak\nreal x\nassume e: x = 0\nshow x > 0\n";
  refuses(second_answer(weak, "contradiction\nterm 1 goal\nequation e: 1\nqed\n"), "without a strict term");
}
