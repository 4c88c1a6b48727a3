// An answer to a small problem, held against all solutions of the problem in exact numbers.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contact/judge/all_solutions.hpp"
#include "contact/problem/every_load.hpp"
#include "contact/problem/mixed_problem.hpp"
#include "contact/problem/solutions.hpp"
#include "contact/problem/yardstick.hpp"

namespace slipproof {

/// Components up to which all modes, 2^12, are tried first: that is faster than deciding whether the matrix is
/// definite.
inline constexpr std::size_t few_components = 12;

struct ProblemAnswer {
  std::vector<Rational> z;
  std::optional<std::vector<Rational>> w;  ///< if the solver gives it
  std::optional<ProblemMode> mode;         ///< claimed by the solver
};

struct SmallJudgement {
  /// unique, solution_within_rho (of several with the same velocities), ambiguous, inaccurate, wrong, no_solution or
  /// undecided
  ContactVerdict verdict = ContactVerdict::undecided;
  /// Solutions of no family first. If trying all modes is beyond the effort, only those of the answer's mode.
  AllSolutions all;
  std::vector<ContactContinuum> continua;      ///< the families in `all`
  std::optional<std::size_t> nearest;          ///< in `all`, to the answer; of the answer's mode if it claims one
  Distance distance;                           ///< of that
  std::optional<EveryLoad::Reason> unique_by;  ///< the theorem by which no other mode was tried
  std::optional<OwnMode> own;                  ///< if no solution is near
  Work needed = 0;  ///< if not all solutions are known: the work that it would take; unlimited if unknown

  /// The solution that is near enough to say that the answer means it; null if there is none.
  const FoundSolution* meant() const;
};

/// What was found of an answer to a small problem, and the problem without its free unknowns.
struct SmallCase {
  EliminatedProblem eliminated;
  SmallJudgement found;
};

/// Compares Distance::scaled (yardstick.hpp) with the tolerance, and with `contact_near` beyond which an answer is
/// wrong. z is one kind of quantity, w and q are another. If z = 0, its yardstick is the largest |q_i / W_ii|. Of
/// infinitely many solutions the nearest counts. The verdict on a right answer is `undecided` if other solutions cannot
/// be excluded: trying every mode is beyond the effort, and the matrix is not positive definite or, with friction, mu
/// is not below the bound of problem/every_load.hpp. Requires that mistake_in(problem) is empty and that `answer` has
/// the size of the problem. Throws TooMuchWork.
SmallJudgement judge_small(const ContactProblem& problem, const ProblemAnswer& answer, double tolerance,
                           Effort& effort);

/// Holds an answer, free unknowns included, against all solutions of a problem in the plane or without friction that
/// has at most `few_components` components. `u` are the velocities that it gives, or empty. Nothing for any other
/// problem, where not all solutions are known, and beyond the effort.
std::optional<SmallCase> small_case(const MixedProblem& problem, std::span<const double> x, std::span<const double> u,
                                    double tolerance, Effort& effort);

}  // namespace slipproof
