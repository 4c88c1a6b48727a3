// Proofs that there is one motion everywhere: their statements are what the determinants of numbers are, at random
// places.
#include "claims/uniqueness/everywhere.hpp"

#include <doctest/doctest.h>

#include <string>

#include "base/expression/parser.hpp"
#include "contact/problem/every_load.hpp"
#include "mechanics/kernel/mode_solver.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/reading/shipped.hpp"
#include "mechanics/scene/narrow.hpp"
#include "mechanics/search/points.hpp"
#include "proofs/check/judge.hpp"

using namespace slipproof;

namespace {

/// Whether the conclusion of a statement holds at numbers.
bool holds_at(const ProblemMaker& maker, const std::string& text, const MechanismValues& values) {
  const std::string shown = text.substr(text.find("show ") + 5);
  auto at = maker.at(values);
  return at.truth(maker.compiled().compile(parse_expression(shown, Sort::truth))) == Truth::yes;
}

}  // namespace

TEST_CASE("statements about all places agree with the determinants of numbers") {
  int unique = 0, not_unique = 0;
  for (const char* name : {"bicycle", "bicycle-two-radii"}) {
    CAPTURE(name);
    const Mechanism m = open_mechanism(name);
    const auto statements = uniqueness_statements(m, false);
    REQUIRE(statements);
    CHECK(statements->modes == 16);
    const ProblemMaker maker(m);
    const PointSampler points(m, maker, 5);
    for (std::uint64_t i = 0; i < 40; ++i) {
      const auto values = points.at(i);
      if (!values) continue;
      const auto problem = contact_problem(without_equations(maker.problem(*values)));
      const bool theorem = problem && for_every_load(*problem).verdict == EveryLoad::Verdict::unique;
      bool all = true;
      for (const CheckedStatement& one : statements->statements) all = all && holds_at(maker, one.text, *values);
      CHECK(all == theorem);
      ++(theorem ? unique : not_unique);
    }
  }
  CHECK(unique > 5);
  CHECK(not_unique > 5);
}

TEST_CASE("what is proved is checked, and what cannot be is not said") {
  const std::string sled =
      "schema = \"slipproof/mechanism/1\"\nname = \"sled\"\n[parameters]\nm = \"m > 0\"\nmu = \"mu >= 0\"\n"
      "nu = \"nu >= mu\"\ng = \"g > 0\"\n[unknowns]\naccelerations = [\"ax\", \"ay\"]\n"
      "[motion]\nax = \"m*ax = 0\"\nay = \"m*ay = -m*g\"\n[[contact]]\nname = \"floor\"\ngap = \"ay\"\n"
      "slip = \"ax\"\nfriction = { static = \"nu\", kinetic = \"mu\" }\n";
  const Mechanism on_snow = parse_mechanism(sled, "sled.toml");
  CHECK_FALSE(unique_everywhere(on_snow, false));
  CHECK(unique_everywhere(narrowed(on_snow, "mu = nu", "within"), false));
  const auto proof = unique_everywhere(on_snow, true);
  REQUIRE(proof);
  CHECK(proof->modes == 4);
  for (const CheckedStatement& one : proof->statements) {
    CHECK(check::judge(one.text, one.certificate).verdict == check::Verdict::accepted);
  }
  const Mechanism bicycle = open_mechanism("bicycle");
  CHECK_FALSE(unique_everywhere(bicycle, true));
  CHECK_FALSE(unique_everywhere(narrowed(bicycle, "J > 0", "within"), true));
  CHECK_FALSE(uniqueness_statements(open_mechanism("painleve-rod"), true));    // it slides
  CHECK_FALSE(uniqueness_statements(open_mechanism("bicycle-brakes"), true));  // friction elements
  const Mechanism cards =
      open_mechanism(std::string(SLIPPROOF_SOURCE_DIR) + "/cases/engines/mechanisms/two-cards.toml");
  CHECK_FALSE(uniqueness_statements(cards, true));  // determinants longer than statements may be
}
