#include "contact/exact/no_solution.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "base/algebra/linear_program.hpp"
#include "lcp_problems.hpp"

using namespace lcp;

namespace {

std::optional<Rationals> multipliers(const MixedProblem& p) {
  Effort effort(20'000'000'000);
  auto y = infeasibility(p, effort);
  if (y) REQUIRE(shows_no_solution(*y, p));
  return y;
}

MixedProblem random_problem(Draw& draw, std::size_t free, std::size_t dimension, std::size_t contacts) {
  const std::size_t n = free + dimension * contacts;
  MixedProblem p = problem(draw.matrix(n, n, -3, 3), draw.vector(n, -4, 2));
  p.free = free;
  p.dimension = dimension;
  p.mu.assign(contacts, 0);
  for (double& mu : p.mu) mu = dimension == 1 ? 0 : 0.25 * draw.whole(0, 4);
  return p;
}

/// Directions whose hull lies in the unit disk and nearly fills it, with radius 1 exactly.
const std::vector<std::pair<Rational, Rational>>& rational_circle() {
  static const auto result = [] {
    std::vector<std::pair<Rational, Rational>> points;
    for (int t = -12; t < 12; ++t) {
      const Rational s(t, 12), d = 1 + s * s;
      points.emplace_back((1 - s * s) / d, 2 * s / d);
      points.emplace_back((s * s - 1) / d, -2 * s / d);
    }
    return points;
  }();
  return result;
}

/// Whether forces in the cones keep all gaps open: by a linear program over the forces themselves, which in dimension 3
/// are sums of forces on the edge of the cone, so that some may be missed.
bool forces_exist(const MixedProblem& p) {
  std::vector<Rationals> generators;  // of x; the first p.free of any sign
  for (std::size_t i = 0; i < p.free; ++i) generators.emplace_back(p.size())[i] = 1;
  for (std::size_t k = 0; k < p.contacts(); ++k) {
    const Rational mu = to_rational(p.mu[k]);
    const auto add = [&](const Rational& first, const Rational& second) {
      Rationals& x = generators.emplace_back(p.size());
      x[p.normal(k)] = 1;
      if (p.dimension > 1) x[p.normal(k) + 1] = mu * first;
      if (p.dimension > 2) x[p.normal(k) + 2] = mu * second;
    };
    if (p.dimension < 3) add(1, 0);
    if (p.dimension == 2) add(-1, 0);
    if (p.dimension < 3) continue;
    for (const auto& [x, y] : rational_circle()) add(x, y);
  }
  std::vector<AffineForm> conditions;
  const AffineForm zero{0, Rationals(generators.size())};
  for (std::size_t g = p.free; g < generators.size(); ++g) conditions.emplace_back(zero).coefficients[g] = 1;
  const auto row = [&](std::size_t i, int factor) {
    AffineForm& form = conditions.emplace_back(zero);
    form.constant = factor * to_rational(p.c[i]);
    for (std::size_t g = 0; g < generators.size(); ++g) {
      form.coefficients[g] = factor * (image(p, generators[g])[i] - to_rational(p.c[i]));
    }
  };
  for (std::size_t i = 0; i < p.free; ++i) {
    row(i, 1);
    row(i, -1);
  }
  for (std::size_t k = 0; k < p.contacts(); ++k) row(p.normal(k), 1);
  return minimize(zero, conditions).kind == LinearOptimum::Kind::attained;
}

}  // namespace

TEST_CASE("in dimensions 1 and 2 multipliers are found if and only if no forces exist") {
  Draw draw(1);
  int found = 0, none = 0;
  for (int i = 0; i < 1500; ++i) {
    const std::size_t dimension = draw.size(1, 2);
    const MixedProblem p = random_problem(draw, draw.size(0, 2), dimension, draw.size(1, 4));
    const auto y = multipliers(p);
    REQUIRE(y.has_value() != forces_exist(p));
    (y ? found : none) += 1;
    if (y && p.free == 0 && p.size() <= 6) {
      Effort effort(10'000'000'000);
      CHECK(count_solutions(p, effort).kind == SolutionCount::Kind::none);
    }
  }
  CHECK(found > 300);
  CHECK(none > 300);
}

TEST_CASE("in dimension 3 multipliers are found only where no forces exist, and nearly always there") {
  Draw draw(2);
  int found = 0, missed = 0, none = 0;
  for (int i = 0; i < 250; ++i) {
    const MixedProblem p = random_problem(draw, draw.size(0, 2), 3, draw.size(1, 2));
    const bool exist = forces_exist(p);
    const auto y = multipliers(p);
    if (exist) REQUIRE(!y);
    (exist ? none : y ? found : missed) += 1;
  }
  CHECK(found > 40);
  CHECK(none > 40);
  CHECK(missed <= found / 20);
}

TEST_CASE("the check is exact") {
  // One contact; y = (1, 0, 0) has g = (-1, g_T), with |g_T| = 5/4 where mu = 4/5 would do and its binary64 does not.
  const auto cone = [](double mu) {
    MixedProblem p = problem({{-1, 0.75, 1}, {0, 1, 0}, {0, 0, 1}}, {-1, 0, 0});
    p.dimension = 3;
    p.mu = {mu};
    return p;
  };
  REQUIRE(to_rational(0.8) > Rational(4, 5));
  CHECK(!shows_no_solution({1, 0, 0}, cone(0.8)));
  CHECK(shows_no_solution({1, 0, 0}, cone(0x1.9999999999999p-1)));
  CHECK(shows_no_solution({1, 0, 0}, cone(0)));
  CHECK(!shows_no_solution({1, 0, 0}, cone(2)));
  CHECK(!shows_no_solution({1, 0, 1}, cone(0)));
  CHECK(!shows_no_solution({1, 0}, cone(0)));
  CHECK(!shows_no_solution({0, 0, 0}, cone(0)));
  CHECK(!shows_no_solution({-1, 0, 0}, cone(0)));

  const MixedProblem slack = problem({{-1}}, {0});
  CHECK(!shows_no_solution({1}, slack));  // c . y = 0: x = 0 is a solution
  CHECK(!shows_no_solution({1}, problem({{1}}, {-1})));
  CHECK(shows_no_solution({1}, problem({{0}}, {-1})));
  CHECK(!shows_no_solution({-1, 1}, problem({{1, 0}, {1, 0}}, {-1, -1})));  // y_1 < 0

  MixedProblem bilateral = problem({{1, 0}, {2, 0}}, {1, 1});  // x_1 = -1, and w = -1
  bilateral.free = 1;
  bilateral.mu = {0};
  CHECK(shows_no_solution({-2, 1}, bilateral));
  CHECK(!shows_no_solution({Rational(-2001, 1000), 1}, bilateral));
  CHECK(multipliers(bilateral));
}

TEST_CASE("multipliers of two dozen components") {
  Draw draw(3);
  for (const std::size_t dimension : {1U, 2U, 3U}) {
    CAPTURE(dimension);
    const std::size_t contacts = 24 / dimension, n = contacts * dimension;
    Matrix A(n, std::vector<double>(n));
    std::vector<double> c;
    for (auto& row : A) {
      for (double& x : row) x = draw.real();
      c.push_back(-std::abs(draw.real()));
    }
    const auto with_forces = [&](double lift) {  // what each normal force adds to every gap
      MixedProblem p = problem(A, c);
      for (std::size_t i = 0; i < n; i += dimension) {
        for (std::size_t j = 0; j < n; j += dimension) p.A.value[i * n + j] += lift;
      }
      p.dimension = dimension;
      p.mu.assign(contacts, dimension == 1 ? 0 : 0.3);
      return p;
    };
    CHECK(!multipliers(with_forces(0.5)));
    // Less than numbers of 53 bits would take.
    Effort for_short_numbers(20'000'000), little(10);
    CHECK(infeasibility(with_forces(-0.1), for_short_numbers));
    CHECK(!infeasibility(with_forces(-2), little));
  }
}
