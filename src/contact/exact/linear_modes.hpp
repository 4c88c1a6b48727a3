// Solutions in the modes whose equations are all linear, each found exactly.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/number/effort.hpp"
#include "contact/enclosure/mode_system.hpp"
#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// Whether contacts in space may slide, in one of four directions: along their tangential axes. Other directions are
/// unknown, and have no linear equations.
enum class Slides : std::uint8_t { none, axes };

/// The number of modes by Coulomb's law in which each contact is open or sticks, is closed where it has no friction, or
/// slides: in the plane always. Endless if more than that.
Work linear_modes(const MixedProblem& problem, Slides slides);

/// The least work of each_linear_solution(): that of error bounds in all of these modes.
Work least_work_of_linear_modes(const MixedProblem& problem, Slides slides);

/// Calls visit(r) with the forces of each solution in these modes, until it returns false. If the equations of a mode
/// leave forces undetermined, these are tried at 0 and at their values in `start`; other solutions of the mode are
/// missed. A solution may be visited several times. The modes form a tree: contacts are decided one after the other,
/// and the forces of closed ones are eliminated from the remaining rows, so that modes share most of the work; in
/// binary64 with error bounds, and exactly where these leave open whether there is a solution. `contacts` is the
/// problem without its free unknowns, `start` has its size. The mode `known`, if given, is left out where its equations
/// have one solution. Throws TooMuchWork.
void each_linear_solution(const MixedProblem& problem, const ContactProblem& contacts, Slides slides,
                          std::span<const double> start, const ConeMode* known, Effort& effort,
                          const std::function<bool(const std::vector<Rational>&)>& visit);

}  // namespace slipproof
