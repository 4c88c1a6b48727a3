// The bicycles of a line as one bicycle whose parameters are polynomials in the line's t.
#pragma once

#include <optional>

#include "model/bicycle.hpp"
#include "model/contact_mode.hpp"
#include "verify/critical_set.hpp"

namespace slipproof {

/// As IntegerScene: units are chosen in which there are no denominators. Here a unit is a polynomial in t, and may be
/// negative somewhere; it vanishes only where something has no value.
struct LineScene {
  Bicycle<IntegerPolynomial> bicycle;
  Road<IntegerPolynomial> road;  ///< f is a numerator
  IntegerPolynomial friction_denominator;
  Affine<IntegerPolynomial> force;  ///< the pedal force, over the force variable
  IntegerPolynomial length, mass, rate;

  IntegerPolynomial unit(Quantity quantity) const;
};

/// The values of a scene along a line, in the order of scene_symbols, J and the force included; no value for J where
/// the setting has none. Nothing if the force is not of degree 1 in its variable.
std::optional<LineScene> line_scene(const std::vector<std::optional<LineFunction>>& values);

}  // namespace slipproof
