#include "contact/judge/verdict.hpp"

#include <array>

namespace slipproof {

std::string_view name(ContactVerdict verdict) {
  constexpr std::array<std::string_view, 13> names{"invalid",
                                                   "wrong",
                                                   "not converged",
                                                   "inaccurate",
                                                   "eps-solution",
                                                   "solution within rho",
                                                   "unique",
                                                   "velocities within rho",
                                                   "velocities of a solution within rho",
                                                   "no solution within rho",
                                                   "no solution",
                                                   "ambiguous",
                                                   "undecided"};
  return names[static_cast<std::size_t>(verdict)];
}

bool is_certified(ContactVerdict verdict) {
  using enum ContactVerdict;
  return verdict == solution_within_rho || verdict == unique || verdict == velocities_within_rho ||
         verdict == velocities_of_a_solution;
}

}  // namespace slipproof
