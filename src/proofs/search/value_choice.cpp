#include "proofs/search/value_choice.hpp"

#include <set>

#include "base/algebra/real_roots.hpp"

namespace slipproof::prove {

namespace {

/// One side of the values that a variable may have.
struct End {
  Rational value;
  bool included;
};

}  // namespace

Rational ValueChoice::anything() {
  const Rational size = simple();
  const std::uint64_t kind = random_() % 8;
  const Rational value = kind == 0 ? Rational(0) : kind < 4 ? size : kind < 6 ? Rational(1 / size) : size * size * 4;
  return random_() % 2 == 0 ? value : Rational(-value);
}

Rational ValueChoice::simple() {
  return Rational(1 + static_cast<int>(random_() % 8), 1 + static_cast<int>(random_() % 2));
}

Rational ValueChoice::between(const std::optional<Rational>& lower, const std::optional<Rational>& upper) {
  if (lower && upper) {
    const int parts = 2 << (random_() % 6);
    const int part = 1 + static_cast<int>(random_() % static_cast<std::uint64_t>(parts - 1));
    return *lower + (*upper - *lower) * Rational(part, parts);
  }
  const Rational size = random_() % 4 == 0 ? Rational(1 / simple()) : simple();
  return lower ? Rational(*lower + size) : upper ? Rational(*upper - size) : anything();
}

std::optional<Rational> ValueChoice::choose_by_roots(std::size_t v, const std::vector<const Condition*>& conditions) {
  std::set<IntegerPolynomial> polynomials;
  std::vector<IntegerPolynomial> all;
  for (const Condition* c : conditions) {
    std::vector<Rational> coefficients;
    for (std::size_t k = 0; k <= c->p.degree(v); ++k) coefficients.push_back(c->p.coefficient(v, k).constant());
    ring_.budget().spend(coefficients.size() * coefficients.size() * 20);
    all.push_back(IntegerPolynomial::proportional_to(coefficients));
    polynomials.insert(all.back());
  }
  const std::vector<RealRoot> roots = real_roots(polynomials);
  std::vector<Rational> values = random_() % 2 == 0 ? cell_points(roots) : std::vector<Rational>();
  for (std::size_t i = 0; i <= roots.size(); ++i) {
    if (i < roots.size() && roots[i].is_rational()) values.push_back(roots[i].lower);
    values.push_back(between(i > 0 ? std::optional(roots[i - 1].upper) : std::nullopt,
                             i < roots.size() ? std::optional(roots[i].lower) : std::nullopt));
  }
  std::erase_if(values, [&](const Rational& value) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!conditions[i]->holds_at(all[i].sign_at(value))) return true;
    }
    return false;
  });
  if (values.empty()) return std::nullopt;
  return values[random_() % values.size()];
}

std::optional<Rational> ValueChoice::choose(std::size_t v, const std::vector<Condition>& conditions) {
  if (roots_) {
    std::vector<const Condition*> alone;
    bool linear = true;
    for (const Condition& c : conditions) {
      if (c.p.variables() != std::vector<std::size_t>{v}) continue;
      alone.push_back(&c);
      linear = linear && c.p.degree(v) == 1;
    }
    if (!linear) return choose_by_roots(v, alone);
  }
  std::optional<End> lower, upper;
  for (const Condition& c : conditions) {
    if (c.is_equation() || c.either_sign || c.p.degree(v) != 1 || c.p.variables().size() != 1) continue;
    const Rational slope = c.p.coefficient(v, 1).constant();
    const Rational end = -c.p.coefficient(v, 0).constant() / slope;
    std::optional<End>& side = slope > 0 ? lower : upper;
    if (side && side->value == end) {
      side->included = side->included && c.sign == Sign::non_negative;
    } else if (!side || (slope > 0 ? end > side->value : end < side->value)) {
      side = End{end, c.sign == Sign::non_negative};
    }
  }
  if (lower && lower->included && random_() % 4 == 0 && !(upper && upper->value < lower->value)) return lower->value;
  if (upper && upper->included && random_() % 4 == 0 && !(lower && upper->value < lower->value)) return upper->value;
  if (lower && upper) {
    if (lower->value == upper->value && lower->included && upper->included) return lower->value;
    if (lower->value >= upper->value) return std::nullopt;
    return lower->value + (upper->value - lower->value) * Rational(1 + static_cast<int>(random_() % 3), 4);
  }
  if (lower) return lower->value + simple();
  if (upper) return upper->value - simple();
  if (roots_) return anything();
  return random_() % 2 == 0 ? simple() : Rational(-simple());
}

}  // namespace slipproof::prove
