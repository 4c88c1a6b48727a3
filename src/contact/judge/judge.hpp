// What can be proved about a solver's answer to a contact problem at real size.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "contact/convex/every_solution.hpp"
#include "contact/enclosure/enclosure.hpp"
#include "contact/enclosure/residual.hpp"
#include "contact/exact/exclusion.hpp"
#include "contact/exact/unique_class.hpp"
#include "contact/judge/all_in_space.hpp"
#include "contact/problem/tolerance.hpp"
#include "contact/ranges/open_forces.hpp"

namespace slipproof {

struct ContactJudgeOptions {
  /// Bound on the error of the answer (sizes.hpp) if a solution is known, otherwise on its backward error.
  double tolerance = contact_tolerance;
  /// Requested radius of solutions that count as near. Without it, `contact_near` times the largest force, and absence
  /// of solutions is not examined.
  std::optional<double> within;
  bool all = false;     ///< find all solutions, in space as well, with proof (all_in_space.hpp)
  bool refine = false;  ///< look for a solution near the answer even if that is wrong
  EnclosureOptions enclosure;
  static constexpr Work usual_effort = 3'000'000'000;
  Work effort = usual_effort;      ///< for theorems about all answers, and for exact solutions: a few seconds
  std::size_t others_up_to = 200;  ///< unknowns of a mode up to which other solutions are looked for
  SearchProgress progress = {};    ///< of the search for all solutions
};

/// A search for other solutions in modes whose equations are linear.
struct LinearSearch {
  Work modes = 0;  ///< the number of modes; unlimited if it overflows
  bool tried = false;
};

struct ContactJudgement {
  ContactVerdict verdict = ContactVerdict::invalid;
  bool moved_inside = false;             ///< the enclosure is of the answer with its forces moved inside of their cones
  std::string reason;                    ///< why nothing stronger is proved; for an invalid answer, its mistake
  std::vector<std::size_t> contacts;     ///< contacts that the reason concerns, from 0
  FrictionLaw law = FrictionLaw::cone;   ///< of the problem
  std::vector<double> x;                 ///< the answer, free unknowns included
  std::optional<Residual> residual;      ///< of every finite answer
  std::optional<Exclusion> exclusion;    ///< of Coulomb's law
  double velocity_error = 0;             ///< largest distance of given velocities from A x + c
  std::optional<FrictionLaw> right_for;  ///< wrong for the cone, and within the tolerance for this pyramid
  std::optional<Enclosure> enclosure;
  double rho = 0;                  ///< largest distance of the enclosure from the answer
  double eta = 0;                  ///< the same of velocities, if it was found along a path or inside of the cones
  std::size_t undetermined = 0;    ///< forces that nothing determines: they are held at the answer's values
  std::optional<OpenForces> open;  ///< of an answer that is right: what its velocities leave open
  double error = 0;  ///< if a solution is known: upper bound on the error, relative to the size of each kind
  std::optional<EverySolution> every;  ///< of convex laws
  std::vector<Rational> exact;         ///< a solution of the problem, rho from the answer, where one was computed
  std::optional<Enclosure> other;      ///< a solution elsewhere: there are several
  std::vector<Rational> other_exact;
  std::optional<LinearSearch> linear_modes;
  std::optional<UniqueProof> unique_by;      ///< why there is no other; without it all modes were tried
  std::vector<Rational> multipliers;         ///< a proof that there is no solution at all (no_solution.hpp)
  std::vector<std::string> left_out;         ///< stronger results that were not reached, each with the reason
  std::optional<AllSolutions> all;           ///< if all are known, the nearest of each family (small.hpp)
  std::optional<AllSolutions> some;          ///< if the search for all of them ended before
  std::shared_ptr<const SolutionTree> tree;  ///< the proof that `all` are all, where it was asked for
  std::optional<OwnMode> own;                ///< the same for an answer that is near none of them

  /// Whether a solution within rho is known.
  bool has_solution() const { return enclosure || !exact.empty() || (every && every->unique()); }
  /// True if the answer is certified and it is proved that there is no other solution, or none with other velocities.
  bool others_excluded() const {
    return verdict == ContactVerdict::unique || (is_certified(verdict) && all && all->one_motion());
  }
  /// Within which no solution is; 0 where nothing is known of it.
  double excluded() const { return std::max(exclusion ? exclusion->radius : 0, every ? every->apart : 0); }
};

/// Whether no verdict on an answer is stronger than `eps-solution`, whatever the answer: of a diamond in space, and of
/// regularised friction, only the residual is judged.
bool is_judged_by_residual(const MixedProblem& problem);

/// The strongest that is proved. `u` is what the answer says of the contacts' velocities; empty if it does not. `tree`
/// is that of an earlier answer to the same problem: all solutions are not searched for again.
ContactJudgement judge_contacts(const MixedProblem& problem, std::vector<double> x, std::span<const double> u,
                                const ContactJudgeOptions& options, std::shared_ptr<const SolutionTree> tree = nullptr);

}  // namespace slipproof
