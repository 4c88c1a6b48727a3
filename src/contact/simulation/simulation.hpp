// Which of several motions compliant contacts settle to, together with all motions of rigid ones. The motions are
// exact; which of them a run reaches is a simulation and not a proof.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "contact/problem/solutions.hpp"
#include "contact/simulation/compliant.hpp"

namespace slipproof {

/// The second half of a run, in which the load is fully applied.
struct SeenMotion {
  double periods = 0;                 ///< duration, including the first half
  std::vector<double> accelerations;  ///< means of gap and slip of each contact
  std::vector<double> forces;         ///< means of N and T
  ProblemMode mode;                   ///< the mode in which the contacts were longest
  double share = 0;                   ///< fraction of the time in that mode
  std::optional<std::size_t> motion;  ///< the exact motion that these accelerations are close to
};

struct SimulatedRun {
  Compliance compliance;
  std::vector<SeenMotion> seen;  ///< by horizon
};

struct Simulation {
  LoadedContacts contacts;
  ContactSolutions exact;
  std::vector<SimulatedRun> runs;
};

/// Periods after which it is looked at, once the load is there: contacts 100 times as stiff make ten of one.
inline constexpr std::array horizons{10.0, 100.0, 1000.0};

/// Accelerations are close to a motion's that are 100 times further from those of all others and, as a vector, from
/// nothing at all (of the size of q). Continua are not looked at.
std::optional<std::size_t> motion_close_to(const std::vector<double>& accelerations, const ContactProblem& problem,
                                           const ContactSolutions& exact);

/// Throws std::invalid_argument, with a message for people, as CompliantMotion does and where the exact motions are
/// too many to try.
Simulation simulate(LoadedContacts contacts, const std::vector<Compliance>& compliances, unsigned threads = 0);

}  // namespace slipproof
