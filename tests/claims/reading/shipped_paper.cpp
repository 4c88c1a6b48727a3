// The shipped paper: its claims, its definitions at a bicycle, and the places of its lines.
#include <doctest/doctest.h>

#include "claims/paper/compiled.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "support/papers/formula.hpp"
#include "support/papers/shipped.hpp"

using namespace slipproof;
using namespace slipproof::test;

TEST_CASE("the shipped paper") {
  const ClaimsFile file = read_claims(SLIPPROOF_SOURCE_DIR "/proofs/rozenblat-yashin/claims.toml");
  for (const char* id : {"A1.1", "A1.2", "A2.1",  "A2.2",  "A2.3",  "A2.4",  "A3.1",  "A3.2",  "A4.1",  "A4.2", "A4.3",
                         "A5.1", "A5.2", "A1.1a", "A1.2a", "A2.1a", "A2.2a", "A2.3a", "A3.1a", "A4.1a", "A4.2a"}) {
    CAPTURE(id);
    const Claim* claim = file.find(id);
    REQUIRE(claim);
    CHECK(claim->line >= 201);
    CHECK(claim->line <= 233);
  }
  // (3.1) at R = 2, h = 3, b = 5, M2 = 1/2, M3 = 1/4, f = 1/3, g = 10, sigma = 1/2, F = 7, worked out apart from this.
  const CompiledClaims compiled(file);
  const CompiledSetting& setting = compiled.settings.at(0);
  Evaluator<Rational> evaluator(setting.scope());
  const std::vector<Rational> values{2, 3, 5, Rational(1, 2), Rational(1, 4), Rational(1, 3), 10, Rational(1, 2), 1};
  for (std::size_t i = 0; i < values.size(); ++i) evaluator.set(CompiledSetting::parameter_slot(i), values[i]);
  evaluator.set(CompiledSetting::force_slot(), 7);
  const auto value = [&](const std::string& expression, Reading reading) {
    return *evaluator.number(setting.compile(number(expression), reading)).number;
  };
  const std::vector<std::pair<std::string, Rational>> expected{
      {"M0", Rational(7, 4)},
      {"M1", Rational(3, 2)},
      {"b0", Rational(13, 6)},
      {"b11", 2},
      {"xi1", Rational(175, 62)},
      {"xi2", Rational(25, 4)},
      {"xi3", Rational(25, 2)},
      {"eta", 4},
      {"xi4", 2},
      {"xi5", Rational(40, 3)},
      {"xi6", 20},
      {"a21", Rational(31, 21)},
      {"a22", Rational(31, 21)},
      {"a31", Rational(38, 23)},
      {"a41", Rational(7, 12)},
      {"s1", Rational(36, 25)},
      {"s2", Rational(-11, 25)},
  };
  for (const auto& symbol_and_value : expected) {
    CAPTURE(symbol_and_value.first);
    CHECK(value(symbol_and_value.first, Reading::printed) == symbol_and_value.second);
  }
  CHECK(value("b1", Reading::printed) == 3);
  CHECK(value("b1", Reading::repaired) == Rational(1, 3));
}

TEST_CASE("lines of a paper's source are told as places in the paper") {
  const Paper& paper = test::shipped_paper().paper;
  const std::vector<std::pair<std::size_t, std::string>> expected{
      {1, ""},
      {37, "Section 1"},
      {53, "Section 1, Problem 1"},
      {72, "Section 1.1, (1.3)"},
      {73, "Section 1.1, after (1.3)"},
      {192, "Section 3, (3.1)"},
      {193, "Section 3, after (3.1)"},
      {201, "Section 3, Assertion 1"},
      {233, "Section 3, Assertion 5"},
      {243, "Section 4"},
      {265, "Section 4.2, (4.3)"},
  };
  for (const auto& [line, place] : expected) CHECK(paper.place(line) == place);
  Paper plain;
  plain.equations = {{"1", 3}};
  CHECK(plain.place(3).empty());
  CHECK(plain.where(3) == "Line 3");
  CHECK(paper.where(233) == "Section 3, Assertion 5 (line 233)");
}
