// Strategy for existence: a value between the bounds that the conclusion's inequalities set.
#include "prove/state.hpp"

namespace slipproof::prove {

namespace {

/// p with a quotient for a variable.
Quotient substituted(const Polynomial& p, std::size_t variable, const Quotient& value) {
  return {substitute(p, variable, value.numerator, value.denominator), power(value.denominator, p.degree(variable))};
}

Quotient operator/(const Quotient& x, const Quotient& y) {
  return {x.numerator * y.denominator, x.denominator * y.numerator};
}

/// x + weight y
Quotient sum(const Quotient& x, const Quotient& y, const Rational& weight) {
  return {x.numerator * y.denominator + (y.numerator * x.denominator).scaled(weight), x.denominator * y.denominator};
}

}  // namespace

struct Search::Bounds {
  std::vector<Quotient> lower, upper;

  /// Values to try: between a lower and an upper bound, or beyond all that there are on one side.
  std::vector<Quotient> candidates(const Ring& ring) const {
    std::vector<Quotient> result;
    const Quotient one{Polynomial(ring, 1), Polynomial(ring, 1)};
    for (const Quotient& l : lower) {
      for (const Quotient& u : upper)
        result.push_back(sum(l, u, 1) / Quotient{Polynomial(ring, 2), Polynomial(ring, 1)});
    }
    if (!result.empty()) return result;
    const auto& bounds = lower.empty() ? upper : lower;
    const int outwards = lower.empty() ? -1 : 1;
    if (bounds.size() == 1) return {sum(bounds.front(), one, outwards)};
    // 1 + x^2 + y^2 is above x and y.
    Quotient beyond = one;
    for (const Quotient& x : bounds) {
      beyond = sum(beyond, {x.numerator * x.numerator, x.denominator * x.denominator}, 1);
    }
    beyond.numerator = beyond.numerator.scaled(outwards);
    return {beyond};
  }
};

/// What the inequalities of the conclusion say of an unknown that its equations leave free, where they are linear in it
/// with a coefficient of known sign.
Search::Bounds Search::bounds_of(State& state, std::size_t free, const std::vector<Quotient>& values) {
  Bounds result;
  const std::function<void(const Formula&)> collect = [&](const Formula& formula) {
    if (formula.kind == Formula::Kind::conjunction) {
      for (const Formula& part : formula.parts) collect(part);
    }
    if (formula.kind != Formula::Kind::atom || formula.sign == Sign::zero) return;
    Polynomial p = formula.polynomial.front();
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (statement_.unknowns()[i] == free) continue;
      const Quotient at = substituted(p, statement_.unknowns()[i], values[i]);
      p = at.numerator * at.denominator;
    }
    budget_.spend(p.length() + 1);
    if (p.degree(free) != 1) return;
    Quotient bound{-p.coefficient(free, 0), p.coefficient(free, 1)};
    const auto known = as_known_product(state, bound.denominator);
    if (!known) return;
    cancel(bound);
    (known->coefficient > 0 ? result.lower : result.upper).push_back(std::move(bound));
  };
  collect(statement_.shown());
  return result;
}

/// Where the conclusion's equations leave one unknown free. Splits, at most so often, on which of two bounds is the
/// stronger one.
bool Search::close_by_bounds(State& state, int splits) {
  const std::vector<Quotient> values = solve_conclusion(state).quotients;
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t unknown = statement_.unknowns()[i];
    if (values[i].numerator == Polynomial::variable(statement_.ring(), unknown)) free.push_back(unknown);
  }
  if (free.size() != 1) return false;
  const Bounds bounds = bounds_of(state, free.front(), values);
  if (bounds.lower.empty() && bounds.upper.empty()) return false;
  for (const Quotient& candidate : bounds.candidates(statement_.ring())) {
    std::vector<std::string> texts;
    for (const Quotient& value : values) {
      texts.push_back((substituted(value.numerator, free.front(), candidate) /
                       substituted(value.denominator, free.front(), candidate))
                          .text());
    }
    State attempt = state;
    if (!close_by_witness(attempt, texts)) continue;
    state = std::move(attempt);
    return true;
  }
  if (splits == 0) return false;
  for (const auto* side : {&bounds.lower, &bounds.upper}) {
    for (std::size_t i = 0; i < side->size(); ++i) {
      for (std::size_t k = i + 1; k < side->size(); ++k) {
        const Polynomial difference = sum((*side)[i], (*side)[k], -1).numerator;
        if (as_known_product(state, difference)) continue;
        if (close_split(state, difference, [&](State& branch) { return close_by_bounds(branch, splits - 1); }))
          return true;
      }
    }
  }
  return false;
}

}  // namespace slipproof::prove
