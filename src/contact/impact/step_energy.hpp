// The energy that contacts put into bodies in a step of an engine in which they may approach.
#pragma once

#include <optional>
#include <span>

#include "contact/formats/problem_file.hpp"

namespace slipproof {

struct StepEnergy {
  Rational work;                   ///< of the contacts' impulses r: the sum of r . (u before + u after)/2
  Rational size;                   ///< the same sum with each term's absolute value
  std::optional<Rational> before;  ///< kinetic energy of all bodies; the global form tells it

  /// Whether energy is gained, where that is more than a part `tolerance` of the energy before, or of `size`; nothing
  /// where it is neither gained nor lost by more.
  std::optional<bool> gains(double tolerance) const;
};

/// Of an answer x = (v, lambda, r) or (lambda, r), of finite numbers, to a problem with an impact; exactly. Velocities
/// of contacts are those of bodies: without w, compliance and bias. With the work of what pushes the bodies in the
/// step, it is the change of their energy. Linear.
StepEnergy step_energy(const ProblemFile& problem, std::span<const double> x);

}  // namespace slipproof
