#include "claims/mutation/claims_mutants.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <string>

#include "claims/paper/compiled.hpp"
#include "support/papers/shipped.hpp"

using namespace slipproof;

namespace {

const Definition& definition(const ClaimsFile& file, const std::string& symbol) {
  const auto& all = file.settings.at(0).definitions;
  return *std::find_if(all.begin(), all.end(), [&](const Definition& d) { return d.symbol == symbol; });
}

}  // namespace

TEST_CASE("a file can be taken in one reading") {
  const ClaimsFile file = test::shipped_paper();
  const ClaimsFile printed = as_read(file, Reading::printed), repaired = as_read(file, Reading::repaired);
  CHECK(to_string(definition(printed, "b1").printed) == "f * h * (2 * M1)");
  CHECK(to_string(definition(repaired, "b1").printed) == "f * h / (2 * M1)");
  CHECK_FALSE(definition(repaired, "b1").repaired);
  CHECK(printed.find("A2.1")->printed.expect == Expectation::refuted);
  CHECK(repaired.find("A2.1")->printed.expect == Expectation::holds);
  CHECK_FALSE(repaired.find("A2.1")->repaired);
}

TEST_CASE("the paper has thousands of mutants, each valid, each another claims file") {
  const ClaimsFile file = as_read(test::shipped_paper(), Reading::repaired);
  const auto all = mutants(file);
  CHECK(all.size() >= 2000);
  std::map<std::optional<BodyPart>, int> kinds;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const ClaimsMutant& mutant = all[i];
    ++kinds[mutant.part];
    CHECK_FALSE(mutant.claims.empty());
    if (i % 500 != 0) continue;
    CAPTURE(mutant.where);
    CAPTURE(mutant.mutant.description);
    const ClaimsFile changed = mutant.apply(file);
    int differences = 0;
    for (std::size_t s = 0; s < file.settings.size(); ++s) {
      for (std::size_t d = 0; d < file.settings[s].definitions.size(); ++d) {
        differences += !same(file.settings[s].definitions[d].printed, changed.settings[s].definitions[d].printed);
      }
    }
    for (std::size_t c = 0; c < file.claims.size(); ++c) {
      const auto before = expressions(file.claims[c].printed), after = expressions(changed.claims[c].printed);
      for (std::size_t k = 0; k < before.size(); ++k) differences += !same(before[k], after[k]);
    }
    CHECK(differences == 1);
    // Circles would never end, and regions must not come to depend on the force.
    const CompiledClaims compiled(changed);
    for (std::size_t c = 0; c < file.claims.size(); ++c) {
      const std::size_t s = file.claims[c].setting;
      Evaluator<Rational> evaluator(compiled.settings[s].scope());
      for (std::size_t p = 0; p < file.settings[s].parameters.size(); ++p) {
        evaluator.set(CompiledSetting::parameter_slot(p), Rational(static_cast<int>(p) + 2, 3));
      }
      CHECK(evaluator.truth(compiled.claims[c].printed.region) != Truth::undecided);
    }
  }
  CHECK(kinds.size() == 6);
}

TEST_CASE("a mutant knows which claims it may change") {
  const ClaimsFile file = as_read(test::shipped_paper(), Reading::printed);
  for (const ClaimsMutant& mutant : mutants(file)) {
    std::vector<std::string> ids;
    for (const std::size_t claim : mutant.claims) ids.push_back(file.claims[claim].id);
    if (mutant.where == "definition xi6 (line 195)") {
      CHECK(ids == std::vector<std::string>{"E3.1.b11", "E3.1.xi6", "A4.1", "A4.1a", "A4.2", "A4.2a", "A4.cover",
                                            "A5.2", "R3.2.2"});
    } else if (mutant.where == "forces of A5.1 (line 233)") {
      CHECK(ids == std::vector<std::string>{"A5.1", "A5.2"});
    }
  }
}
