#include "mechanics/impact/impact_energy.hpp"

#include <algorithm>
#include <utility>

namespace slipproof {

namespace {

Range range_product(const Range& x, const Range& y, bool square) {
  if (!x.lower || !x.upper || !y.lower || !y.upper) return {};
  std::vector<Rational> corners;
  for (const Rational& one : {*x.lower, *x.upper}) {
    for (const Rational& other : {*y.lower, *y.upper}) corners.push_back(one * other);
  }
  if (square) {
    corners = {*x.lower * *x.lower, *x.upper * *x.upper};
    if (x.lower->sign() < 0 && x.upper->sign() > 0) corners.emplace_back(0);
  }
  const auto [least, most] = std::ranges::minmax(corners);
  return {least, most};
}

void add_range(Range& sum, const Rational& factor, Range term) {
  if (factor.sign() < 0) std::swap(term.lower, term.upper);
  const auto end = [&](std::optional<Rational>& to, const std::optional<Rational>& by) {
    to = to && by ? std::optional(Rational(*to + factor * *by)) : std::nullopt;
  };
  end(sum.lower, term.lower);
  end(sum.upper, term.upper);
}

}  // namespace

ImpactEnergy::ImpactEnergy(const Mechanism& mechanism, const ProblemMaker& maker, const MechanismValues& values,
                           const std::optional<Rational>& load) {
  Evaluator<Rational> at = maker.at(values);
  if (load) at.set(maker.compiled().load(), *load);
  const auto number = [&](const Expression& expression) {
    auto value = at.number(maker.compiled().compile(expression));
    if (!value.number) throw NoValue("a velocity before the impact has no value: it divides by zero");
    return std::move(*value.number);
  };
  const MechanismImpact& impact = *mechanism.impact;
  for (const Expression& velocity : impact.velocities) velocities_.push_back(number(velocity));
  driven_ = std::ranges::any_of(impact.prescribed, [&](const Expression& one) { return !number(one).is_zero(); });
  for (std::size_t i = 0; i < velocities_.size(); ++i) {
    auto row = coefficients(maker.compiled().equations[i], at, mechanism.unknowns.size());
    if (!row) throw NoValue("the equation " + mechanism.equations[i].name + " has no value: it divides by zero");
    row->resize(velocities_.size());
    masses_.push_back(std::move(*row));
  }
  before_ = of(velocities_);
}

EnergyBalance ImpactEnergy::balance(const Range& after) const {
  if (driven_) return EnergyBalance::not_judged;
  if (after.lower && *after.lower > before_) return EnergyBalance::gained;
  return after.upper && *after.upper <= before_ ? EnergyBalance::not_gained : EnergyBalance::undecided;
}

Range ImpactEnergy::of(const std::vector<Range>& velocities) const {
  Range sum{Rational(0), Rational(0)};
  for (std::size_t i = 0; i < masses_.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const Rational factor = i == j ? Rational(masses_[i][i] / 2) : Rational((masses_[i][j] + masses_[j][i]) / 2);
      if (!factor.is_zero()) add_range(sum, factor, range_product(velocities[i], velocities[j], i == j));
    }
  }
  return sum;
}

Rational ImpactEnergy::of(const std::vector<Rational>& velocities) const {
  std::vector<Range> points;
  for (const Rational& velocity : velocities) points.push_back({velocity, velocity});
  return *of(points).lower;
}

}  // namespace slipproof
