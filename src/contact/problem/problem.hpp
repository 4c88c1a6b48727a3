// Contact problems as nonsmooth mechanics and complementarity solvers write them: w = W z + q.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/algebra/elimination.hpp"
#include "mechanics/kernel/regular_modes.hpp"

namespace slipproof {

/// Without `mu` a linear complementarity problem: z >= 0, w >= 0, z_i w_i = 0.
/// With it planar frictional contact: z = (N_1, T_1, N_2, T_2, ...) are the normal and tangential forces (or impulses),
/// w = (gap_1, slip_1, ...) the accelerations (or velocities) of the contacts, each contact in one of the states of
/// ElementState with its conditions: slip+ has T = -mu N, slip >= 0.
struct ContactProblem {
  RationalMatrix W;          ///< square; the Delassus matrix, M of an LCP
  std::vector<Rational> q;   ///< w without contact forces
  std::vector<Rational> mu;  ///< Coulomb coefficient of each contact, >= 0; empty for an LCP

  bool frictional() const { return !mu.empty(); }
  std::size_t size() const { return q.size(); }
  /// Contacts; in an LCP, components.
  std::size_t contacts() const { return frictional() ? mu.size() : q.size(); }
  ElementKind kind() const {
    return {.law = frictional() ? ElementKind::Law::coulomb : ElementKind::Law::frictionless};
  }
};

/// Describes a mistake in the sizes or the domain of a problem; empty if there is none.
std::string mistake_in(const ContactProblem& problem);
inline constexpr std::size_t max_problem_size = 64;

/// A state for each contact. A component of an LCP is a contact without friction: `touch` stands for
/// w_i = 0 <= z_i, `lift` for z_i = 0 <= w_i.
using ProblemMode = std::vector<ElementState>;

/// `stick/slip+/lift`; of an LCP a letter for each component, the one of z and w that need not be 0: `zwz`.
std::string name(const ContactProblem& problem, const ProblemMode& mode);
/// Reads a mode as name() writes it; nothing for any other text.
std::optional<ProblemMode> parse_mode(const ContactProblem& problem, std::string_view text);

/// `N1 >= 0`, `|T1| <= mu N1`, `slip2 <= 0`, `gap2 >= 0`; `z3 >= 0`, `w3 >= 0`. Contacts and components count from 1.
std::string name(const ContactProblem& problem, const ViolatedCondition& condition);

/// W z + q.
std::vector<Rational> accelerations(const ContactProblem& problem, const std::vector<Rational>& z);

/// The problem for the kernel; its unknowns are z, so that a motion is a z.
FrictionProblem friction_problem(const ContactProblem& problem);

}  // namespace slipproof
