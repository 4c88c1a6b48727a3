#include "base/algebra/linear_program.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace slipproof;
using Kind = LinearOptimum::Kind;

namespace {

/// The least value over the corners of a bounded feasible set in the plane or in space, by trying every one.
std::optional<Rational> least_corner(const AffineForm& objective, const std::vector<AffineForm>& constraints) {
  const std::size_t n = objective.coefficients.size();
  std::optional<Rational> least;
  std::vector<std::size_t> chosen(n);
  const auto determinant = [&](const std::vector<std::vector<Rational>>& m) {
    if (n == 2) return Rational(m[0][0] * m[1][1] - m[0][1] * m[1][0]);
    Rational sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      sum += m[0][i] * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] - m[1][(i + 2) % 3] * m[2][(i + 1) % 3]);
    }
    return sum;
  };
  const auto visit = [&](const auto& self, std::size_t depth, std::size_t from) -> void {
    if (depth < n) {
      for (std::size_t i = from; i < constraints.size(); ++i) {
        chosen[depth] = i;
        self(self, depth + 1, i + 1);
      }
      return;
    }
    std::vector<std::vector<Rational>> m;
    for (const std::size_t i : chosen) m.push_back(constraints[i].coefficients);
    const Rational d = determinant(m);
    if (d.is_zero()) return;
    std::vector<Rational> x;
    for (std::size_t k = 0; k < n; ++k) {  // Cramer's rule
      auto replaced = m;
      for (std::size_t i = 0; i < n; ++i) replaced[i][k] = -constraints[chosen[i]].constant;
      x.push_back(determinant(replaced) / d);
    }
    for (const AffineForm& c : constraints) {
      if (c.at(x).sign() < 0) return;
    }
    const Rational value = objective.at(x);
    if (!least || value < *least) least = value;
  };
  visit(visit, 0, 0);
  return least;
}

}  // namespace

TEST_CASE("the optimum is the best corner of a bounded set, and infeasible sets are told") {
  std::mt19937_64 random(5);
  const auto small = [&](int low, int high) {
    return Rational(low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1)));
  };
  int infeasible = 0, attained = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const std::size_t n = 2 + random() % 2;
    const auto form = [&](int offset) {
      AffineForm f{small(-4, 4) + offset, {}};
      for (std::size_t i = 0; i < n; ++i) f.coefficients.push_back(small(-2, 2));
      return f;
    };
    std::vector<AffineForm> constraints;
    for (std::size_t i = 0; i < n; ++i) {  // |x_i| <= 3
      for (const int sign : {1, -1}) {
        AffineForm f{3, std::vector<Rational>(n)};
        f.coefficients[i] = sign;
        constraints.push_back(f);
      }
    }
    for (auto more = random() % 5; more > 0; --more) constraints.push_back(form(-2));
    const AffineForm objective = form(0);
    const LinearOptimum found = minimize(objective, constraints);
    const auto expected = least_corner(objective, constraints);
    REQUIRE((found.kind == Kind::attained) == expected.has_value());
    if (!expected) {
      CHECK(found.kind == Kind::infeasible);
      ++infeasible;
      continue;
    }
    ++attained;
    CHECK(found.value == *expected);
    CHECK(objective.at(found.x) == *expected);
    for (const AffineForm& c : constraints) CHECK(c.at(found.x).sign() >= 0);
    // The multipliers prove that nothing is lower.
    REQUIRE(found.multipliers.size() == constraints.size());
    AffineForm rest = objective;
    rest.constant -= found.value;
    for (std::size_t i = 0; i < constraints.size(); ++i) {
      CHECK(found.multipliers[i].sign() >= 0);
      rest.constant -= found.multipliers[i] * constraints[i].constant;
      for (std::size_t k = 0; k < n; ++k) rest.coefficients[k] -= found.multipliers[i] * constraints[i].coefficients[k];
    }
    CHECK(rest.constant.is_zero());
    for (const Rational& coefficient : rest.coefficients) CHECK(coefficient.is_zero());
  }
  CHECK(infeasible > 50);
  CHECK(attained > 50);
}

TEST_CASE("a limit on pivots ends the search, and is not reached by who needs fewer") {
  const std::vector<AffineForm> constraints = {{3, {1, 0}}, {3, {-1, 0}}, {3, {0, 1}}, {3, {0, -1}}, {-1, {1, 1}}};
  const AffineForm objective{0, {2, 3}};
  const LinearOptimum found = minimize(objective, constraints);
  REQUIRE(found.kind == Kind::attained);
  REQUIRE(found.pivots > 0);
  CHECK(minimize(objective, constraints, found.pivots).value == found.value);
  const LinearOptimum ended = minimize(objective, constraints, found.pivots - 1);
  CHECK(ended.kind == Kind::given_up);
  CHECK(ended.pivots == found.pivots - 1);
}

TEST_CASE("unbounded and degenerate programs end") {
  CHECK(minimize({0, {1}}, {}).kind == Kind::unbounded);
  CHECK(minimize({0, {1}}, {{5, {-1}}}).kind == Kind::unbounded);
  CHECK(minimize({7, {0}}, {{5, {-1}}}).value == 7);
  CHECK(minimize({0, {1, 1}}, {{0, {1, 0}}}).kind == Kind::unbounded);
  CHECK(minimize({0, {1, 0}}, {{-2, {1, 1}}, {-2, {1, -1}}}).value == 2);
  CHECK(minimize({0, {1}}, {{-1, {0}}}).kind == Kind::infeasible);
  CHECK(minimize({0, {}}, {{-1, {}}}).kind == Kind::infeasible);
  CHECK(minimize({3, {}}, {}).value == 3);
  // Beale's example, on which the largest-coefficient rule cycles.
  const std::vector<AffineForm> beale{{0, {Rational(-1, 4), 60, Rational(1, 25), -9}},
                                      {0, {Rational(-1, 2), 90, Rational(1, 50), -3}},
                                      {1, {0, 0, -1, 0}},
                                      {0, {1, 0, 0, 0}},
                                      {0, {0, 1, 0, 0}},
                                      {0, {0, 0, 1, 0}},
                                      {0, {0, 0, 0, 1}}};
  CHECK(minimize({0, {Rational(-3, 4), 150, Rational(-1, 50), 6}}, beale).value == Rational(-1, 20));
}

TEST_CASE("one program has the least value of each objective, after any others") {
  std::mt19937_64 random(6);
  const auto form = [&](std::size_t n) {
    AffineForm f{static_cast<int>(random() % 7) - 2, {}};
    for (std::size_t i = 0; i < n; ++i) f.coefficients.emplace_back(static_cast<int>(random() % 5) - 2);
    return f;
  };
  int unbounded = 0, attained = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const std::size_t n = 1 + random() % 4;
    std::vector<AffineForm> constraints;
    for (auto more = random() % 8; more > 0; --more) constraints.push_back(form(n));
    LinearProgram program(n, constraints);
    CHECK(program.is_feasible() == (minimize(form(n), constraints).kind != Kind::infeasible));
    for (int k = 0; program.is_feasible() && k < 5; ++k) {
      const AffineForm objective = form(n);
      const LinearOptimum alone = minimize(objective, constraints);
      const auto least = program.least(objective);
      REQUIRE(least.has_value() == (alone.kind == Kind::attained));
      if (least) CHECK(*least == alone.value);
      ++(least ? attained : unbounded);
    }
  }
  CHECK(unbounded > 50);
  CHECK(attained > 50);
}
