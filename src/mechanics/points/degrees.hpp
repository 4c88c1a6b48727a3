// Angles in degrees as rational points of the unit circle.
#pragma once

#include <utility>

#include "mechanics/points/problem.hpp"

namespace slipproof {

struct AngleFromDegrees {
  MechanismValues::Circle point;
  /// The angle that is taken less the one that was asked for, in degrees, as a number of three digits: 0 if it is
  /// exact.
  Rational difference;
};

/// The point with the binary64 nearest to tan(angle/2); quarter turns are exact.
AngleFromDegrees angle_from_degrees(const Rational& degrees);

/// Least and largest numbers of so many decimals between which the angle of (x, y), seen from 0, lies, in (-180, 180];
/// one number where the angle is an eighth of a turn or several, as no other angle of a rational direction is rational
/// (Niven). At least one coordinate is not 0.
std::pair<Rational, Rational> degrees_of_direction(const Rational& x, const Rational& y, unsigned decimals);

/// The point of the circle with this tan(angle/2).
MechanismValues::Circle point_of_tan_half(const Rational& tan_half);

}  // namespace slipproof
