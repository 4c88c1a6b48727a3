#include "claims/sampling/simplify.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "claims/reading/read_claims_file.hpp"
#include "support/papers/small_claims.hpp"

using namespace slipproof;

namespace {

/// Three parameters, so that a search without any cleverness can go through all of them.
const std::string three_parameters =
    test::SmallClaims{.parameters = R"(b = { domain = "b > 0", line = 1, meaning = "b" }
f = { domain = "f > 0", line = 1, meaning = "f" }
h = { domain = "h > -1", line = 1, meaning = "h" }
)",
                      .in_setting = "boundaries = [\"b = f*h\"]\n",
                      .claims = R"([[claim]]
id = "C1"
line = 1
statement = "any"
kind = "interval"
mode = "stick/stick"
forces = "0 < F < 1"
)"}
        .text();

using Fails = std::function<bool(const std::vector<Rational>&)>;

/// The simplest failing sample, by going through all of height at most `top`.
std::vector<Rational> by_brute_force(const CompiledSetting& setting, const Fails& fails, int top) {
  std::vector<Rational> numbers;
  for (int d = 1; d <= top; ++d) {
    for (int n = -top; n <= top; ++n) {
      const Rational x(n, d);
      if (std::find(numbers.begin(), numbers.end(), x) == numbers.end()) numbers.push_back(x);
    }
  }
  std::vector<Rational> best;
  for (const auto& x : numbers) {
    for (const auto& y : numbers) {
      for (const auto& z : numbers) {
        const std::vector<Rational> values{x, y, z};
        if (!in_domain(setting, values) || !fails(values)) continue;
        if (best.empty() || complexity(values) < complexity(best)) best = values;
      }
    }
  }
  return best;
}

}  // namespace

TEST_CASE("the counterexample found is a simplest one: as simple as brute force finds") {
  const ClaimsFile file = parse_claims(three_parameters, "small.toml");
  const CompiledClaims compiled(file);
  const CompiledSetting& setting = compiled.settings[0];
  const std::vector<std::pair<Fails, std::vector<Rational>>> failures{
      {[](const auto&) { return true; }, {Rational(17, 5), Rational(8, 9), Rational(7, 3)}},
      {[](const auto& v) { return v[0] > Rational(7, 3) && v[1] < Rational(2, 3); }, {9, Rational(1, 8), 4}},
      {[](const auto& v) { return v[0] + v[1] + v[2] < Rational(9, 10); }, {Rational(1, 9), Rational(1, 7), 0}},
      {[](const auto& v) { return v[2] < 0 && v[0] > v[1]; }, {5, 3, Rational(-6, 7)}},
      {[](const auto& v) { return v[0] * v[1] > 3 && v[2] < Rational(1, 2) && v[2] > Rational(1, 4); },
       {7, 9, Rational(7, 20)}},
  };
  for (const auto& failure : failures) {
    REQUIRE(failure.first(failure.second));
    const Simplified found = *simplify(setting, failure.second, failure.first);
    CHECK(found.minimal);
    CHECK(failure.first(found.values));
    CHECK(in_domain(setting, found.values));
    const auto simplest = by_brute_force(setting, failure.first, 5);
    CHECK(complexity(found.values).height == complexity(simplest).height);
    CHECK(complexity(found.values).non_one == complexity(simplest).non_one);
  }
}

TEST_CASE("a failure of a boundary stays on it") {
  const ClaimsFile file = parse_claims(three_parameters, "small.toml");
  const CompiledClaims compiled(file);
  const Fails on_boundary = [](const auto& v) { return v[0] == v[1] * v[2] && v[2] > 1; };
  const Simplified found =
      *simplify(compiled.settings[0], {Rational(55, 21), Rational(5, 7), Rational(11, 3)}, on_boundary);
  CHECK(found.values == std::vector<Rational>{2, 1, 2});
}

TEST_CASE("out of budget: still a failing sample, simpler than the first, and not called minimal") {
  const ClaimsFile file = parse_claims(three_parameters, "small.toml");
  const CompiledClaims compiled(file);
  const Fails far = [](const auto& v) { return v[0] > 1000 && v[1] > 900; };
  const std::vector<Rational> start{Rational(1000001, 7), Rational(99999, 11), Rational(3, 7)};
  const Simplified found = *simplify(compiled.settings[0], start, far, Among::all, 500);
  CHECK(far(found.values));
  CHECK_FALSE(found.minimal);
  CHECK(complexity(found.values) < complexity(start));
}
