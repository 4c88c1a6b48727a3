// The verdicts on an answer to a contact problem.
#pragma once

#include <cstdint>
#include <string_view>

namespace slipproof {

enum class ContactVerdict : std::uint8_t {
  invalid,        ///< NaN, infinity, or no answer of the problem's size
  wrong,          ///< the backward error is above the tolerance, and no solution near it is known
  not_converged,  ///< the backward error is above the tolerance, and a solution is near it
  inaccurate,     ///< it solves a problem within the tolerance, but the solution near it is farther away than that
  eps_solution,   ///< it solves a problem within the tolerance; nothing stronger is proved
  solution_within_rho,       ///< an exact solution is within rho of it, and within the tolerance
  unique,                    ///< and there is no other solution
  velocities_within_rho,     ///< nothing determines some forces; the velocities of every solution are within eta
  velocities_of_a_solution,  ///< an exact solution's velocities are within eta of it; forces that rounding decides
                             ///< differ
  none_within_rho,           ///< no exact solution within the requested radius
  no_solution,               ///< the problem has none at all
  ambiguous,                 ///< it is one of several
  undecided                  ///< no answer was given, and none was found
};
std::string_view name(ContactVerdict verdict);
/// `solution_within_rho`, `unique`, `velocities_within_rho` and `velocities_of_a_solution`: all that one could ask of
/// an answer.
bool is_certified(ContactVerdict verdict);

}  // namespace slipproof
