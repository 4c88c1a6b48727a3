#include "contact/ranges/force_set.hpp"

#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"
#include "contact/enclosure/fit.hpp"

namespace slipproof {

namespace {

constexpr double root_two_above = 1.4142135623730952;

/// Bounds on the length of a vector of at most two components.
Binary64Bounds length(std::span<const Rational> v) {
  double lower = 0, upper = 0;
  for (const Rational& x : v) {
    const Binary64Bounds size = enclose(abs(x));
    lower = std::hypot(lower, size.lower);
    upper = std::hypot(upper, size.upper);
  }
  return {lower * (1 - 0x1p-50), upper * (1 + 0x1p-50)};
}

/// The direction in which the contact certainly slides, into `set`: so its force is on a ray, up to a spread.
void slide(ForceSet& set, std::span<const Rational> slip, double change) {
  const double least = length(slip).lower;
  if (slip.size() == 1) {
    if (least <= change) return;
    set.slip = {Rational(slip[0].sign())};
  } else {
    if (least <= 8 * change) return;
    const auto [x, y] = unit_direction(nearest_binary64(slip[0]), nearest_binary64(slip[1]));
    set.slip = {x, y};
    // |v / |v| - e| <= 2 |v - w| / |w| for e = w / |w|
    set.spread = set.mu * to_rational(2 * root_two_above * change / least * (1 + 0x1p-50) + 0x1p-48);
  }
  set.kind = ForceSet::Kind::ray;
}

}  // namespace

Rational ForceSet::lack(std::span<const Rational> z) const {
  const std::span<const Rational> tangential = z.subspan(1);
  Rational most = -z[0];
  if (kind == Kind::none) return 0;
  if (kind == Kind::cone) {
    most += mu * (tangential.size() == 1 ? Rational(abs(tangential[0])) : to_rational(length(tangential).upper));
  } else {
    for (std::size_t t = 0; t < slip.size(); ++t) most += mu * tangential[t] * slip[t];
    if (!spread.is_zero()) most += spread * to_rational(length(tangential).upper);
  }
  return std::max(most, Rational(0));
}

std::vector<ForceSet> force_sets(const MixedProblem& problem, std::span<const Rational> w, double change) {
  std::vector<ForceSet> sets;
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    const std::span<const Rational> u = w.subspan(problem.normal(k), problem.dimension), slip = u.subspan(1);
    ForceSet& set = sets.emplace_back();
    set.mu = to_rational(problem.mu[k]);
    Rational opens = to_rational(change);
    if (problem.law.kind == FrictionLaw::associated && problem.dimension > 1) {
      opens += set.mu * to_rational((length(slip).upper + root_two_above * change) * (1 + 0x1p-50));
    }
    if (u[0] > opens) continue;
    if (set.mu.is_zero() || problem.dimension == 1) {
      set.kind = ForceSet::Kind::ray;
      continue;
    }
    set.kind = ForceSet::Kind::cone;
    slide(set, slip, change);
  }
  return sets;
}

}  // namespace slipproof
