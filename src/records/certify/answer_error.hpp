// How far an answer can be from the motion of a mode, by numbers with error bounds.
#pragma once

#include "floating/filter/bounded_motion.hpp"
#include "mechanics/bicycle/forced_scene.hpp"
#include "records/certify/record.hpp"

namespace slipproof {

/// What a component that is 0 is held against: not above the yardstick of its kind (MechanismAnswer).
template <class Real>
struct ZeroScales {
  Real acceleration, rotation, force;
};

/// g, g over the longest lever, M g. number(x) gives a number of the scene as Real.
template <class Real, class T, class Number>
ZeroScales<Real> zero_scales(const ForcedScene<T>& scene, const Number& number) {
  const Bicycle<T>& p = scene.bicycle;
  const Real g = number(scene.road.g), h = absolute(number(p.h)), b2 = absolute(number(p.b2)),
             b3 = absolute(number(p.b3));
  Real lever = number(p.R);
  lever = lever < h ? h : lever;
  lever = lever < b2 ? b2 : lever;
  lever = lever < b3 ? b3 : lever;
  return {g, g / lever, number(p.M) * g};
}

/// Upper bound on the relative error of the answer against the motion of a mode; infinite where that is not known. Real
/// is binary64 or several side by side, N the number with bounds that belongs to it; number(field) gives the answer's
/// value of a field.
template <class Real, class N, class Number>
Real largest_error(const ReducedDynamics<N, N>& dynamics, ContactMode mode, std::uint32_t present, const Number& number,
                   const ZeroScales<Real>& scales) {
  constexpr double up = 1 + 8 * unit_roundoff;
  const ReducedMotion<N, N> motion(dynamics, mode);
  const Real unknown = Real{} + std::numeric_limits<double>::infinity();
  Real worst{};
  for (std::size_t i = 0; i < answer_count; ++i) {
    const auto field = static_cast<Field>(parameter_count + i);
    if ((present & bit(field)) == 0) continue;
    const Real z = number(field);
    const auto [value, error] = bounded_parts<Real>(motion.quantity(answer_quantities[i]));
    const Real distance = (absolute(Real(z - value)) * up + error) * up + 2 * unit_roundoff * absolute(z);
    const Real size = absolute(value) - error;
    const bool lifted = mode[i == 5 || i == 7 ? Wheel::rear : Wheel::front] == ContactState::lift;
    // Forces on a wheel in the air, and what only they turn: the front wheel. On the road C neither rises nor turns.
    const bool exactly_zero = i >= 4 ? lifted : (i == 1 || i == 2) && mode.on_road();
    Real relative = unknown;
    if (exactly_zero) {
      const Real& scale = i >= 5 ? scales.force : i == 1 ? scales.acceleration : scales.rotation;
      relative = absolute(z) / scale * (1 + 16 * unit_roundoff);
    }
    relative = size > 0 ? Real(distance / size * up) : relative;
    worst = worst < relative ? relative : worst;
  }
  return worst;
}

}  // namespace slipproof
