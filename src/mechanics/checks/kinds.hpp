// Which quantities of a mechanism may be compared: those of one kind, as contact/problem/yardstick.hpp needs them.
//
// Quantities are of one kind if they have the same unit. If the file gives no units, they are of one kind if an
// equation, gap, slip or zero adds them with coefficients that are plain numbers (numbers, cosines and sines,
// parameters of unit 1); gap and slip of one contact are of one kind, and so are N and S. Everything else stays apart.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// A line adds quantities of one kind. The lines are the equations of FrictionProblem, then those of its accelerations
/// that are gaps and slips.
struct MechanismKinds {
  /// A quantity of this kind that occurs in a line of another kind: the line and an unknown. Line over coefficient is
  /// of this kind.
  struct Quotient {
    std::size_t kind = 0, of = 0;
    std::vector<std::pair<std::size_t, std::size_t>> places;
  };

  explicit MechanismKinds(const Mechanism& mechanism);

  std::size_t unknown(std::size_t index) const {
    return index < unknown_accelerations ? accelerations[index] : forces[index - unknown_accelerations];
  }
  /// The form of a line, of any type.
  template <class Problem>
  static const auto& line(const Problem& problem, std::size_t unknown_accelerations, std::size_t index) {
    const std::size_t equations = problem.equations.size();
    return index < equations ? problem.equations[index]
                             : problem.accelerations[unknown_accelerations + index - equations];
  }

  std::size_t count = 0, unknown_accelerations = 0;
  std::vector<std::size_t> accelerations;  ///< indices into FrictionProblem::accelerations
  std::vector<std::size_t> forces;         ///< indices into FrictionProblem::forces
  std::vector<bool> own_force;             ///< for each force: belongs to no contact, friction element or link
  std::vector<std::size_t> lines;
  /// Accelerations by what the equations apply: of kinds that a contact's gap or slip has, or that have no lever.
  std::vector<Quotient> inertias;
  /// Accelerations in gaps, slips and zeros of another kind: rotations by the lengths of levers.
  std::vector<Quotient> levers;
  /// The quotients for all unknowns in all rows of another kind.
  std::vector<Quotient> all;
};

}  // namespace slipproof
