// An answer to a small problem, held against all solutions of the problem in exact numbers.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "contact/judge/judge.hpp"
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
  /// The solution that an answer means: the nearest, of the answer's mode where it claims one.
  struct Meant {
    std::vector<ProblemMode> modes;
    std::vector<Rational> z;
    Distance distance;
  };
  ContactVerdict verdict = ContactVerdict::undecided;  ///< unique, ambiguous, inaccurate, wrong or undecided
  ProblemMode looks_like;                              ///< the mode that the answer claims, or suggests
  std::optional<ContactSolutions> all;                 ///< nothing where finding them is beyond the effort
  std::vector<std::vector<Rational>> members;  ///< for each continuum in `all`, its solution nearest to the answer
  std::optional<Meant> meant;
  std::optional<EveryLoad::Reason> unique_by;  ///< the theorem by which no other mode was tried
  /// The outcome of the mode `looks_like`, for a wrong answer, or if not all solutions are known.
  std::optional<ModeOutcome> own;
  Work needed = 0;  ///< if not all solutions are known: the work that it would take; unlimited if unknown

  /// Whether `meant` is near enough to say that the answer means it.
  bool near() const;
};

/// A small problem, an answer to it, and what was found.
struct SmallCase {
  EliminatedProblem eliminated;  ///< the problem without its free unknowns
  ProblemAnswer answer;
  SmallJudgement found;

  const ContactProblem& problem() const { return eliminated.problem; }
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
/// has at most `few_components` components. `u` are the velocities that it gives, or empty. Null for any other problem,
/// where not all solutions are known, and beyond the effort.
std::shared_ptr<const SmallCase> small_case(const MixedProblem& problem, std::span<const double> x,
                                            std::span<const double> u, double tolerance, Effort& effort);

}  // namespace slipproof
