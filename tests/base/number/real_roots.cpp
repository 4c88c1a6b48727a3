#include "base/algebra/real_roots.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace slipproof;

namespace {

using Polynomials = std::set<IntegerPolynomial>;

IntegerPolynomial t_minus(const Rational& root) {
  return {Integer(-numerator(root)), denominator(root)};
}

IntegerPolynomial power(const IntegerPolynomial& p, int exponent) {
  IntegerPolynomial result(1);
  for (int i = 0; i < exponent; ++i) result = result * p;
  return result;
}

/// From the leading coefficient down.
IntegerPolynomial polynomial(const std::vector<int>& coefficients) {
  IntegerPolynomial result;
  for (const int c : coefficients) result = result * IntegerPolynomial(0, 1) + IntegerPolynomial(Integer(c));
  return result;
}

std::vector<Rational> exact(const std::vector<RealRoot>& roots) {
  std::vector<Rational> values;
  for (const RealRoot& root : roots) {
    CHECK(root.is_rational());
    values.push_back(root.lower);
  }
  return values;
}

/// Ascending, apart, and with the polynomial changing its sign where it is of odd multiplicity.
void check_apart(const std::vector<RealRoot>& roots, const LinePart& part = {}) {
  for (std::size_t i = 1; i < roots.size(); ++i) CHECK(roots[i - 1].upper < roots[i].lower);
  const auto points = cell_points(roots, part);
  REQUIRE(points.size() == roots.size() + 1);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    CHECK(points[i] < roots[i].lower);
    CHECK(roots[i].upper < points[i + 1]);
  }
}

}  // namespace

TEST_CASE("real roots: rational ones exactly, multiple ones and those of several polynomials once") {
  const IntegerPolynomial p = power(t_minus(Rational(1, 3)), 3) * t_minus(-2) * polynomial({1, 0, 1});
  const IntegerPolynomial q = t_minus(Rational(1, 3)) * t_minus(Rational(100001, 100000)) * t_minus(1);
  CHECK(exact(real_roots(Polynomials{p, q, IntegerPolynomial(), IntegerPolynomial(5)})) ==
        std::vector<Rational>{-2, Rational(1, 3), 1, Rational(100001, 100000)});
  CHECK(exact(real_roots(Polynomials{p, q}, {Rational(1, 3), Rational(2)})) ==
        std::vector<Rational>{1, Rational(100001, 100000)});
  CHECK(exact(real_roots(Polynomials{p, q}, {std::nullopt, Rational(1, 3)})) == std::vector<Rational>{-2});
  CHECK(real_roots({}).empty());
  CHECK(cell_points({}) == std::vector<Rational>{0});
}

TEST_CASE("real roots: 1, 2, ..., 20 of Wilkinson's polynomial, and those that it has when one coefficient is moved") {
  IntegerPolynomial wilkinson(1);
  for (int root = 1; root <= 20; ++root) wilkinson = wilkinson * t_minus(root);
  const auto roots = exact(real_roots(Polynomials{wilkinson}));
  REQUIRE(roots.size() == 20);
  for (int i = 0; i < 20; ++i) CHECK(roots[static_cast<std::size_t>(i)] == i + 1);
  // t^19 by 2^-23: ten of the roots leave the real line.
  const IntegerPolynomial scaled = wilkinson * IntegerPolynomial(Integer(1 << 23));
  const auto moved = real_roots(Polynomials{scaled - power(IntegerPolynomial(0, 1), 19)});
  CHECK(moved.size() == 10);
  check_apart(moved);
}

TEST_CASE("real roots: irrational ones lie between two numbers, those of different polynomials apart") {
  const IntegerPolynomial two = polynomial({1, 0, -2});  // sqrt 2
  const Rational near(Integer("14142135623730950488"), Integer("10000000000000000000"));
  // t^6 - 8 has the same real roots; a number agrees with one of them in twenty digits.
  const auto roots = real_roots(Polynomials{two, t_minus(near), polynomial({1, 0, 0, 0, 0, 0, -8}) * two});
  REQUIRE(roots.size() == 3);
  check_apart(roots);
  CHECK(roots[1].is_rational());
  CHECK(roots[2].lower * roots[2].lower < 2);
  CHECK(roots[2].upper * roots[2].upper > 2);
  // Mignotte: t^7 - 2 (50 t - 1)^2 has two roots very close to 1/50.
  const IntegerPolynomial mignotte =
      power(IntegerPolynomial(0, 1), 7) - IntegerPolynomial(2) * power(t_minus(Rational(1, 50)), 2);
  const auto close = real_roots(Polynomials{mignotte});
  CHECK(close.size() == 3);
  check_apart(close);
}

TEST_CASE("real roots of random products: as many as there are, and one number for each cell") {
  std::mt19937 engine(3);
  const auto number = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine); };
  for (int i = 0; i < 200; ++i) {
    std::set<Rational> expected;
    Polynomials polynomials;
    for (int k = number(1, 6); k > 0; --k) {
      const Rational x(number(-30, 30), number(1, 12)), y(number(-30, 30), number(1, 12));
      expected.insert({x, y});
      polynomials.insert(power(t_minus(x), number(1, 3)) * t_minus(y) * polynomial({1, number(-3, 3), 9}));
    }
    const LinePart part{Rational(-7, 2), number(0, 1) == 0 ? std::optional<Rational>() : Rational(5, 3)};
    std::erase_if(expected, [&](const Rational& x) { return x <= *part.lower || (part.upper && x >= *part.upper); });
    const auto roots = real_roots(polynomials, part);
    const auto values = exact(roots);
    CHECK(std::set<Rational>(values.begin(), values.end()) == expected);
    check_apart(roots, part);
  }
}

TEST_CASE("integer polynomials: signs, order and moving") {
  const IntegerPolynomial p = polynomial({2, -3, 0, 1});
  for (const Rational& t : {Rational(-1, 2), Rational(1), Rational(7, 3), Rational(0)}) {
    CHECK(p.sign_at(t) == sign(Rational(2 * t * t * t - 3 * t * t + 1)));
    CHECK(p.beyond(Rational(-5, 3)).sign_at(t) == p.sign_at(t - Rational(5, 3)));
    CHECK(p.mirrored().sign_at(t) == p.sign_at(-t));
    CHECK(p.stretched_twice().sign_at(t) == p.sign_at(t / 2));
    CHECK(p.on_unit(Rational(-5, 3), Rational(1, 2)).sign_at(t) == p.sign_at(Rational(13, 6) * t - Rational(5, 3)));
  }
  CHECK(p.sign_changes() == 2);
  CHECK(p.on_unit(-1, 0).sign_changes_in_unit() == 1);
  CHECK(p.on_unit(2, 3).sign_changes_in_unit() == 0);
  CHECK((p * IntegerPolynomial(-6)).primitive() == p);
  CHECK(exact_quotient(p, t_minus(1)) == polynomial({2, -1, -1}));
  CHECK(gcd(p, t_minus(1)) == t_minus(1));
}

TEST_CASE("the cells of a line cover its part, each number in one of them, and have their samples inside") {
  const IntegerPolynomial p = t_minus(Rational(1, 3)) * polynomial({1, 0, -2}) * t_minus(2);  // 1/3, -+sqrt(2), 2
  for (const LinePart& part :
       {LinePart{}, LinePart{Rational(-5), Rational(7, 5)}, LinePart{Rational(0), std::nullopt}}) {
    const std::vector<RealRoot> roots = real_roots(Polynomials{p}, part);
    const std::vector<LineCell> cells = line_cells(roots, part);
    const std::size_t ends = (part.lower ? 1U : 0U) + (part.upper ? 1U : 0U);
    REQUIRE(cells.size() == 2 * roots.size() + 1 + ends);
    CHECK(cells.front().lower.has_value() == part.lower.has_value());
    CHECK(cells.back().upper.has_value() == part.upper.has_value());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const LineCell& cell = cells[i];
      CHECK(cell.is_point() == (i % 2 == (part.lower ? 0 : 1)));
      if (i > 0) {
        REQUIRE(cell.lower);
        CHECK(cell.lower->upper == cells[i - 1].upper->upper);
      }
      if (!cell.is_point()) {
        REQUIRE(cell.sample);
        CHECK((!cell.lower || cell.lower->upper < *cell.sample));
        CHECK((!cell.upper || *cell.sample < cell.upper->lower));
      } else {
        CHECK(cell.sample.has_value() == cell.lower->is_rational());
        if (cell.sample) CHECK(*cell.sample == cell.lower->lower);
      }
    }
  }
}
