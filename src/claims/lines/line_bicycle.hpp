// The bicycles of a line as one bicycle whose parameters are polynomials in the line's t.
//
// What LineMechanism finds for any mechanism, by the reduced equations of the bicycle: these have fewer critical values
// and take a fraction of the time.
#pragma once

#include <optional>
#include <vector>

#include "claims/lines/line_mechanism.hpp"
#include "mechanics/bicycle/bicycle.hpp"
#include "mechanics/bicycle/contact_mode.hpp"
#include "mechanics/bicycle/reduction.hpp"

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

/// What the scene's symbols are along the line.
struct SceneAlongLine {
  Bicycle<LineFunction> bicycle;
  Road<LineFunction> road;
  LineFunction force;
};

/// The same of a setting of the bicycle, as LineMechanism.
class LineBicycle {
 public:
  LineBicycle(const CompiledSetting& setting, LineEvaluator& paper);

  bool has_value() const { return scene_.has_value(); }
  bool add_mode(const MechanismMode& mode, const std::vector<std::size_t>& wanted, CriticalSet& found,
                LineEvaluator& paper) const;

 private:
  using LineMotion = ReducedMotion<IntegerPolynomial, Affine<IntegerPolynomial>>;
  void set_quantities(const LineMotion& motion, const std::vector<std::size_t>& wanted, LineEvaluator& paper) const;

  const CompiledSetting& setting_;
  std::optional<SceneAlongLine> values_;
  std::optional<LineScene> scene_;
  std::optional<ReducedDynamics<IntegerPolynomial, Affine<IntegerPolynomial>>> dynamics_;
};

}  // namespace slipproof
