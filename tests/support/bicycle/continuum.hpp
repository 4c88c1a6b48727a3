// Singular contact modes: no motion, or a continuum of them; found by the kernel's spaces and linear programs.
#pragma once

#include <optional>
#include <vector>

#include "mechanics/kernel/polyhedron.hpp"
#include "support/bicycle/bicycle.hpp"
#include "support/bicycle/contact_mode.hpp"

namespace slipproof {

/// All solutions of a mode whose equations are singular: base(F) + sum of t_i directions[i], for the forces that the
/// equations admit, under the mode's conditions.
class Continuum {
 public:
  ContactMode mode;
  Motion<Affine<Rational>> base;             ///< the solution with all parameters 0
  std::vector<Motion<Rational>> directions;  ///< one for each free parameter, linearly independent
  ForceInterval closed;                      ///< forces for which some solution meets all conditions
  ForceInterval strict;                      ///< the same with all conditions strict

  /// The range of each parameter over the consistent motions at a force; nothing if there are none.
  std::optional<std::vector<ForceInterval>> parameter_ranges(const Rational& force) const;

 private:
  friend class SingularModes;
  std::vector<AffineForm> conditions_;
  std::vector<AffineForm> free_;         ///< the unknowns that are free parameters
  std::optional<Polyhedron> solutions_;  ///< those that meet the conditions
};

/// The modes of a scene by elimination in its raw equations. What all modes share is eliminated once.
class SingularModes {
 public:
  SingularModes(const Bicycle<Rational>& bicycle, const Road<Rational>& road, ForceKind kind);

  /// Nothing if the equations of a mode have no solution for any force. Meant for singular modes; a regular mode comes
  /// back with no directions.
  std::optional<Continuum> solve(ContactMode mode) const;

 private:
  Bicycle<Rational> bicycle_;
  Road<Rational> road_;
  AffineSpace in_every_mode_;  ///< the solutions of the equations of motion
  bool solvable_ = true;
};

}  // namespace slipproof
