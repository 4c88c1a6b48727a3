#include <doctest/doctest.h>

#include <optional>
#include <random>
#include <set>
#include <vector>

#include "base/algebra/linear_program.hpp"
#include "base/algebra/real_roots.hpp"
#include "mechanics/lines/polynomial_rows.hpp"

using namespace slipproof;

namespace {

constexpr std::size_t unknowns = 2;  // beside the force

/// Random conditions with coefficients linear in t, some of them zero, some rows alike.
std::vector<PolynomialRow> random_conditions(std::mt19937& random) {
  std::uniform_int_distribution<int> count(3, 6), number(-3, 3), one_in_four(0, 3);
  std::vector<PolynomialRow> rows(static_cast<std::size_t>(count(random)));
  for (PolynomialRow& row : rows) {
    for (std::size_t j = 0; j < unknowns + 2; ++j) {
      const int slope = one_in_four(random) == 0 ? number(random) : 0;
      row.push_back(one_in_four(random) == 0 ? IntegerPolynomial(0)
                                             : IntegerPolynomial(Integer(number(random)), Integer(slope)));
    }
  }
  if (one_in_four(random) == 0) rows.push_back(rows.front());
  return rows;
}

/// What Chernikov's rule must leave: the polynomials of all combinations, as the lines of a mode collect them.
std::set<IntegerPolynomial> critical(const std::vector<PolynomialRow>& rows) {
  CriticalSet found;
  Conditions conditions(rows, found);
  for (std::size_t column = 0; column <= unknowns; ++column) REQUIRE(conditions.eliminate(column));
  for (const PolynomialRow& row : conditions.rows()) found.add(row.back());
  return found.polynomials();
}

Rational value_at(const IntegerPolynomial& p, const Rational& t) {
  Rational value(0);
  for (long power = p.degree(); power >= 0; --power) value = value * t + Rational(p.coefficient(power));
  return value;
}

/// What the simplex method says of the mode at a place: whether there are solutions, whether some meet all conditions
/// strictly, whether the force is bounded from below and from above, and whether it has one value only.
std::vector<bool> shape(const std::vector<PolynomialRow>& rows, const Rational& t) {
  constexpr std::size_t slack = unknowns + 1;
  std::vector<AffineForm> constraints, with_slack;
  for (const PolynomialRow& row : rows) {
    AffineForm form;
    for (std::size_t j = 0; j <= unknowns; ++j) form.coefficients.push_back(value_at(row[j], t));
    form.constant = value_at(row.back(), t);
    form.coefficients.emplace_back(0);
    constraints.push_back(form);
    form.coefficients[slack] = -1;
    with_slack.push_back(form);
  }
  const auto unit = [&](std::size_t variable, int factor) {
    AffineForm form{0, std::vector<Rational>(unknowns + 2)};
    form.coefficients[variable] = factor;
    return form;
  };
  with_slack.push_back(unit(slack, -1));
  with_slack.back().constant = 1;
  using Kind = LinearOptimum::Kind;
  const LinearOptimum least = minimize(unit(unknowns, 1), constraints),
                      most = minimize(unit(unknowns, -1), constraints);
  if (least.kind == Kind::infeasible) return {};
  const LinearOptimum strict = minimize(unit(slack, -1), with_slack);
  const bool bounded = least.kind == Kind::attained && most.kind == Kind::attained;
  return {strict.value < 0, least.kind == Kind::attained, most.kind == Kind::attained,
          bounded && least.value == -most.value};
}

}  // namespace

TEST_CASE("between two critical places the forces of a mode keep their shape") {
  std::mt19937 random(61);
  std::size_t with_forces = 0, changes = 0;
  for (int system = 0; system < 400; ++system) {
    const std::vector<PolynomialRow> rows = random_conditions(random);
    const LinePart part{Rational(-4), Rational(4)};
    const std::vector<RealRoot> roots = real_roots(critical(rows), part);
    std::optional<Rational> lower = part.lower;
    std::optional<std::vector<bool>> before;
    for (std::size_t cell = 0; cell <= roots.size(); ++cell) {
      const Rational from = *lower, to = cell < roots.size() ? roots[cell].lower : *part.upper;
      const auto there = [&](int eighths) { return shape(rows, from + (to - from) * Rational(eighths, 8)); };
      const std::vector<bool> middle = there(4);
      CHECK(there(1) == middle);
      CHECK(there(7) == middle);
      with_forces += middle.empty() ? 0 : 1;
      changes += before && *before != middle ? 1 : 0;
      before = middle;
      if (cell < roots.size()) lower = roots[cell].upper;
    }
  }
  CHECK(with_forces > 300);
  CHECK(changes > 100);
}

TEST_CASE("combinations of more conditions than Chernikov's rule allows are left out") {
  // Nine conditions and two unknowns: every three of them are combined once, not every two of the 36 combined twos.
  std::mt19937 random(9);
  std::uniform_int_distribution<int> number(1, 1000);
  std::vector<PolynomialRow> rows(9);
  for (PolynomialRow& row : rows) {
    for (std::size_t j = 0; j < unknowns + 2; ++j) row.emplace_back(Integer(number(random)), Integer(number(random)));
  }
  CriticalSet found;
  Conditions conditions(rows, found);
  REQUIRE(conditions.eliminate(0));
  CHECK(conditions.rows().size() == 36);
  REQUIRE(conditions.eliminate(1));
  CHECK(conditions.rows().size() == 84);
}
