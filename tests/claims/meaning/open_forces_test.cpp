// Motions whose accelerations leave their forces open: the same motion is then in several modes, perhaps with forces
// that only one of them allows.
#include <doctest/doctest.h>

#include "claims/reading/read_claims_file.hpp"
#include "claims/statements/claim_statements.hpp"
#include "support/papers/proved.hpp"
#include "support/run_program.hpp"

using namespace slipproof;
using test::proved;

namespace {

/// N and S stand in one equation only: for mu > 1 it has a solution that presses, and one that pulls.
ClaimsFile one_sliding_contact(const std::string& domain_of_mu) {
  const test::TemporaryFolder folder;
  folder.write("mechanism.toml", R"(
schema = "slipproof/mechanism/1"
name = "own"
reciprocal = false
[parameters]
mu = { domain = "mu > 0" }
[load]
symbol = "F"
[unknowns]
accelerations = ["ax", "ay"]
[equations]
one = "ax = F"
two = "ay = -1 + N_u - S_u"
[[contact]]
name = "u"
gap = "ay"
slip = "ax"
friction = "mu"
bilateral = true
)");
  return parse_claims(R"(
schema = "slipproof/claims/1"
paper = { title = "own", authors = ["nobody"], source = "none" }
[[setting]]
id = "all"
mechanism = "mechanism.toml"
motions = "strict"
force = { symbol = "F", domain = "true" }
parameters = { mu = { domain = ")" +
                          domain_of_mu +
                          R"(", meaning = "friction" } }
[[claim]]
id = "slips"
line = 1
statement = "own"
kind = "interval"
mode = "slip+"
forces = "F > 1 or 0 < F <= 1"
[[claim]]
id = "alone"
line = 1
statement = "own"
kind = "unique"
claims = ["slips"]
forces = "F > 0"
[[claim]]
id = "listed"
line = 1
statement = "own"
kind = "motions"
modes = ["slip+"]
forces = "F > 0"
)",
                      (folder.path() / "claims.toml").string());
}

}  // namespace

TEST_CASE("a motion that two modes have, with other forces in each, is proved to be the only one") {
  const ClaimsFile file = one_sliding_contact("mu > 1");
  for (const char* id : {"alone", "listed"}) {
    const auto statements = claim_statements(file, *file.find(id), Reading::printed);
    CHECK(statements.size() >= 3);
    for (const NamedStatement& statement : statements) {
      CAPTURE(statement.text);
      CHECK(proved(statement) == ProofOutcome::Verdict::proved);
    }
  }
}

TEST_CASE("the second mode of a motion refutes nothing") {
  const ClaimsFile file = one_sliding_contact("mu > 0");
  for (const char* id : {"alone", "listed"}) {
    for (const NamedStatement& statement : claim_refutation(file, *file.find(id), Reading::printed)) {
      CAPTURE(statement.text);
      CHECK(proved(statement) != ProofOutcome::Verdict::proved);
    }
  }
}
