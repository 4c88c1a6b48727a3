// Judges the answer to a contact problem: is it the one solution?
#pragma once

#include "contact/problem/solutions.hpp"
#include "contact/problem/yardstick.hpp"
#include "records/judging/judge.hpp"

namespace slipproof {

struct ProblemAnswer {
  std::vector<Rational> z;
  std::optional<std::vector<Rational>> w;  ///< if the solver gives it
  std::optional<ProblemMode> mode;         ///< claimed by the solver
};

/// Gives the same verdicts as for a scene, but by the rule of contact/tolerance.hpp: Distance::scaled of
/// contact/yardstick.hpp is compared with options.tolerance, and options.near is not used. z is one kind of quantity, w
/// and q are another. If z = 0, its yardstick is the largest |q_i / W_ii|. Of infinitely many solutions the nearest
/// counts. The verdict on a right solution is `undecided` if other solutions cannot be excluded: trying every mode is
/// beyond the effort, and the matrix is not positive definite or, with friction, mu is not below the bound of
/// contact/every_load.hpp. Requires that mistake_in(problem) is empty and that `answer` has the size of the problem.
RecordJudgement judge_problem(const ContactProblem& problem, const ProblemAnswer& answer, const JudgeOptions& options);

}  // namespace slipproof
