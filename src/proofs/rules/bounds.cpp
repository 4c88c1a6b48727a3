#include "proofs/rules/bounds.hpp"

#include "proofs/branch/signs.hpp"

namespace slipproof::prove {

namespace {

/// The inequalities of a conjunction.
void collect_inequalities(const Formula& formula, std::vector<std::pair<Polynomial, Sign>>& result) {
  if (formula.kind == Formula::Kind::conjunction) {
    for (const Formula& part : formula.parts) collect_inequalities(part, result);
  }
  if (formula.kind == Formula::Kind::atom && formula.sign != Sign::zero)
    result.emplace_back(formula.polynomial.front(), formula.sign);
}

}  // namespace

std::vector<Quotient> Bounds::candidates(const Ring& ring) const {
  std::vector<Quotient> result = between_or_beyond(ring);
  result.insert(result.end(), attained.begin(), attained.end());
  return result;
}

std::vector<Quotient> Bounds::between_or_beyond(const Ring& ring) const {
  std::vector<Quotient> result;
  const Quotient one{Polynomial(ring, 1), Polynomial(ring, 1)};
  for (const Quotient& l : lower) {
    for (const Quotient& u : upper) {
      result.push_back(sum(l, u, 1) / Quotient{Polynomial(ring, 2), Polynomial(ring, 1)});
    }
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

Bounds bounds_of(Context& context, State& state, std::size_t free, const std::vector<Quotient>& values) {
  const std::vector<std::size_t>& unknowns = context.statement().unknowns();
  std::vector<std::pair<Polynomial, Sign>> inequalities;
  collect_inequalities(context.statement().shown(), inequalities);
  Bounds result;
  for (auto& [p, sign] : inequalities) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (unknowns[i] == free) continue;
      const Quotient at = substituted(p, unknowns[i], values[i]);
      p = at.numerator * at.denominator;
    }
    context.budget().spend(p.length() + 1);
    if (p.degree(free) != 1) continue;
    Quotient bound{-p.coefficient(free, 0), p.coefficient(free, 1)};
    const auto known = as_known_product(context, state, bound.denominator);
    if (!known) continue;
    cancel(context, bound);
    if (sign == Sign::non_negative) result.attained.push_back(bound);
    (known->coefficient > 0 ? result.lower : result.upper).push_back(std::move(bound));
  }
  return result;
}

}  // namespace slipproof::prove
