#include "base/algebra/real_roots.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/algebra/factor_base.hpp"
#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "base/number/simplest.hpp"

namespace slipproof {

namespace {

/// A root with its irreducible polynomial, so that it can be located more precisely.
struct Found {
  RealRoot place;
  const IntegerPolynomial* polynomial;
  int sign_below = 0;  ///< of it below the root, once it was asked for
  double near = nearest_binary64(place.lower);
};

bool inside(const Rational& t, const LinePart& part) {
  return (!part.lower || *part.lower < t) && (!part.upper || t < *part.upper);
}

/// By Descartes' rule of signs: `false` is certain.
bool may_have_roots(const IntegerPolynomial& p, const LinePart& part) {
  if (part.lower && part.upper) return p.on_unit(*part.lower, *part.upper).sign_changes_in_unit() > 0;
  if (part.lower) return p.beyond(*part.lower).sign_changes() > 0;
  if (part.upper) return p.mirrored().beyond(-*part.upper).sign_changes() > 0;
  return true;
}

/// Bisection by Descartes' rule (Vincent, Collins and Akritas): the number of sign changes of the polynomial of an
/// interval is 0 where there is no root and, once the interval is small, 1 where there is one. It needs a polynomial
/// without multiple roots; here it is irreducible and not linear, so that no rational end of an interval is a root.
/// An interval comes with its polynomial moved to (0, 1), from which those of its halves take one scaling and one
/// shift.
class Isolation {
 public:
  explicit Isolation(const IntegerPolynomial& p) : p_(p) {}

  void isolate(const LinePart& part, std::vector<Found>& roots) {
    Integer limit;
    fmpz_poly_bound_roots(limit.flint(), p_.flint());
    Rational far(1);
    while (far <= Rational(limit)) far *= 2;
    Rational lower = -far, upper = far;
    if (part.lower && *part.lower > lower) lower = *part.lower;
    if (part.upper && *part.upper < upper) upper = *part.upper;
    if (lower < upper) split(lower, upper, p_.on_unit(lower, upper), roots);
  }

 private:
  void split(const Rational& lower, const Rational& upper, const IntegerPolynomial& moved, std::vector<Found>& roots) {
    if (moved.sign_changes() == 0) return;
    const int changes = moved.sign_changes_in_unit();
    if (changes == 0) return;
    if (changes == 1) {
      roots.push_back({{lower, upper}, &p_});
      return;
    }
    // Zero is the first middle: sizes then differ by powers of two from one side to the other.
    if (sign(lower) < 0 && sign(upper) > 0) {
      split(lower, 0, p_.on_unit(lower, 0), roots);
      split(0, upper, p_.on_unit(0, upper), roots);
      return;
    }
    const Rational middle = (lower + upper) / 2;
    const IntegerPolynomial left = moved.stretched_twice();
    split(lower, middle, left, roots);
    split(middle, upper, left.beyond(1), roots);
  }

  const IntegerPolynomial& p_;
};

/// Half of the interval. The sign at its lower end stays what it is.
void refine(Found& root) {
  RealRoot& place = root.place;
  if (place.is_rational()) return;
  Rational middle = (place.lower + place.upper) / 2;
  if (root.sign_below == 0) root.sign_below = root.polynomial->sign_at(place.lower);
  const bool below = root.polynomial->sign_at(middle) == root.sign_below;
  if (below) root.near = nearest_binary64(middle);
  (below ? place.lower : place.upper) = std::move(middle);
}

/// Rounding keeps the order of numbers, so that most need no exact comparison.
bool precedes(const Found& x, const Found& y) {
  if (x.near != y.near) return x.near < y.near;
  return std::tie(x.place.lower, x.place.upper) < std::tie(y.place.lower, y.place.upper);
}

/// Sorted, with a gap between each two: roots of different irreducible polynomials differ, so that this ends.
void separate(std::vector<Found>& roots) {
  for (bool moved = true; moved;) {
    moved = false;
    std::sort(roots.begin(), roots.end(), precedes);
    for (std::size_t i = 1; i < roots.size(); ++i) {
      while (roots[i - 1].place.upper >= roots[i].place.lower && roots[i].place.upper >= roots[i - 1].place.lower) {
        refine(roots[i - 1]);
        refine(roots[i]);
        moved = true;
      }
    }
  }
}

}  // namespace

std::vector<RealRoot> real_roots(const std::set<IntegerPolynomial>& polynomials, const LinePart& part) {
  std::vector<const IntegerPolynomial*> with_roots;
  for (const IntegerPolynomial& p : polynomials) {
    if (p.degree() > 0 && may_have_roots(p, part)) with_roots.push_back(&p);
  }
  std::ranges::stable_sort(with_roots, {}, &IntegerPolynomial::degree);
  FactorBase base;
  for (const IntegerPolynomial* p : with_roots)
    base.add(*p, [&](const IntegerPolynomial& rest) { return may_have_roots(rest, part); });
  std::vector<Found> found;
  for (const IntegerPolynomial& p : base.factors()) {
    if (p.degree() > 1) {
      Isolation(p).isolate(part, found);
    } else {
      const Rational root(-p.coefficient(0), p.coefficient(1));
      if (inside(root, part)) found.push_back({{root, root}, &p});
    }
  }
  separate(found);
  // Separates roots from the ends of the part, too.
  for (Found& root : found) {
    while (!root.place.is_rational() && (root.place.lower == part.lower || root.place.upper == part.upper))
      refine(root);
  }
  std::vector<RealRoot> roots;
  for (Found& root : found) {
    if (!root.place.is_rational()) root.place.polynomial = std::make_shared<const IntegerPolynomial>(*root.polynomial);
    roots.push_back(std::move(root.place));
  }
  return roots;
}

void halve(RealRoot& root) {
  if (root.is_rational()) return;
  Found found{root, root.polynomial.get()};
  refine(found);
  root = std::move(found.place);
}

double nearest_binary64(RealRoot& root) {
  double lower = nearest_binary64(root.lower), upper = nearest_binary64(root.upper);
  while (lower != upper) {
    halve(root);
    lower = nearest_binary64(root.lower);
    upper = nearest_binary64(root.upper);
  }
  return lower;
}

std::string text_of(const IntegerPolynomial& polynomial, const std::string& symbol) {
  std::string text;
  for (long power = polynomial.degree(); power >= 0; --power) {
    const Integer c = polynomial.coefficient(power);
    if (c == 0) continue;
    const Integer size = abs(c);
    text += text.empty() ? (c < 0 ? "-" : "") : (c < 0 ? " - " : " + ");
    if (size != 1 || power == 0) text += exact_text(Rational(size)) + (power > 0 ? "*" : "");
    if (power > 0) text += symbol;
    if (power > 1) text += "^" + std::to_string(power);
  }
  return text.empty() ? "0" : text;
}

std::vector<Rational> cell_points(const std::vector<RealRoot>& roots, const LinePart& part) {
  std::vector<Rational> points;
  std::optional<Rational> below = part.lower;
  for (const RealRoot& root : roots) {
    points.push_back(simplest_between(below, root.lower));
    below = root.upper;
  }
  points.push_back(simplest_between(below, part.upper));
  return points;
}

std::vector<LineCell> line_cells(const std::vector<RealRoot>& roots, const LinePart& part) {
  std::vector<Rational> inside = cell_points(roots, part);
  std::vector<LineCell> cells;
  const auto end = [](const std::optional<Rational>& x) { return x ? std::optional(RealRoot{*x, *x}) : std::nullopt; };
  const auto add_point = [&](const std::optional<RealRoot>& x) {
    if (x) cells.push_back({x, x, x->is_rational() ? std::optional(x->lower) : std::nullopt});
  };
  std::optional<RealRoot> lower = end(part.lower);
  add_point(lower);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    std::optional<RealRoot> upper = i == roots.size() ? end(part.upper) : std::optional(roots[i]);
    cells.push_back({std::move(lower), upper, std::move(inside[i])});
    add_point(upper);
    lower = std::move(upper);
  }
  return cells;
}

}  // namespace slipproof
