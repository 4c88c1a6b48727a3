// A rational scene brought to integers by a choice of units: no denominator enters the elimination.
#pragma once

#include "base/number/affine.hpp"
#include "base/number/rational.hpp"
#include "mechanics/bicycle/bicycle.hpp"
#include "mechanics/bicycle/contact_mode.hpp"

namespace slipproof {

/// The parameters of a scene in units in which they are integers. A true value is the integer divided by its unit.
struct IntegerScene {
  Bicycle<Integer> bicycle;
  Road<Integer> road;            ///< f is the numerator of the Coulomb coefficient
  Integer friction_denominator;  ///< its denominator
  Integer length;                ///< units in a metre
  Integer mass;                  ///< units in a kilogram
  Integer rate;                  ///< units of 1/s^2 in one 1/s^2
  Integer acceleration;          ///< units in one m/s^2: length rate
  Integer force;                 ///< units in a newton: mass length rate

  /// Units of the quantity in its SI unit.
  const Integer& unit(Quantity quantity) const;
};

IntegerScene to_integers(const Bicycle<Rational>& bicycle, const Road<Rational>& road);

}  // namespace slipproof
