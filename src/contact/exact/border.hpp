// Exact solutions where contacts are at a border between modes: touching without load, or at the edge of their cones.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/number/effort.hpp"
#include "contact/enclosure/mode_system.hpp"

namespace slipproof {

struct BorderSolution {
  std::vector<Rational> x;
  std::size_t undetermined = 0;  ///< forces that are held
};

/// A solution near x in a mode whose equations are all linear: no contact slides in space. Floating point finds the
/// contacts that are at a border near x; those without load are taken to be open, then the modes that differ in a few
/// of them are tried. Each mode is solved without rounding, with undetermined forces held at their values in x, and all
/// of its equations and conditions are decided exactly. At a border intervals must fail: the condition holds with
/// equality. Example: W = diag(2, 1), q = (-2, 0): x = (1, 0) is a solution, with w = 0 and x = 0 in the second
/// component. Nothing if no such mode has a solution, or beyond the effort; see exact_solution() for the cost.
std::optional<BorderSolution> solve_at_border(const MixedProblem& problem, std::span<const double> x, Effort& effort);

}  // namespace slipproof
