// A planar mechanism in numbers: what the kernel solves. Mechanisms from files and contact problems (W, q, mu) both
// become one of these.
#pragma once

#include <string>
#include <vector>

#include "motions/element.hpp"
#include "motions/force_interval.hpp"
#include "number/linear_program.hpp"

namespace slipproof {

/// The forms of one element. A contact has gap and N, with friction also slip, S and its limits mu_s N and mu_k N; a
/// friction element has slip, S and its limits. What it does not have stays empty.
struct ProblemElement {
  ElementKind kind;
  AffineForm gap, normal;    ///< N pushes the bodies apart
  AffineForm slip, tangent;  ///< S acts along positive slip
  AffineForm static_limit, kinetic_limit;
};

/// Unknowns x_0, x_1, ... and a load: all forms are affine, with as many coefficients as there are unknowns and that of
/// the load after them (0 in a problem without one).
struct FrictionProblem {
  std::size_t unknowns = 0;
  std::vector<AffineForm> equations;      ///< vanish in every mode
  std::vector<AffineForm> accelerations;  ///< what a motion consists of: unknown accelerations, gaps and slips
  std::vector<AffineForm> forces;         ///< what else is asked for, perhaps undetermined
  std::vector<ProblemElement> elements;
  bool has_load = false;
  ForceInterval load_domain;  ///< the loads that are asked about

  std::size_t load_index() const { return unknowns; }
};

/// The left-hand side of an equation, which vanishes, and of a condition, which is >= 0.
AffineForm form_of(const ProblemElement& element, ElementState state, StateEquation equation);
AffineForm form_of(const ProblemElement& element, ElementState state, StateCondition condition);

/// Sums of forms of the same length.
AffineForm operator+(AffineForm x, const AffineForm& y);
AffineForm operator-(AffineForm x, const AffineForm& y);
AffineForm operator-(AffineForm x);

}  // namespace slipproof
