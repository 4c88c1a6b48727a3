// Judging the answer to a contact problem: is it the one solution?
#pragma once

#include "contact/problem/solutions.hpp"
#include "records/certify/judge.hpp"

namespace slipproof {

struct ProblemAnswer {
  std::vector<Rational> z;
  std::optional<std::vector<Rational>> w;  ///< where the solver gives it
  std::optional<ProblemMode> mode;         ///< claimed by the solver
};

/// Verdicts as for a scene, but by the rule of contact/tolerance.hpp: Distance::scaled of contact/yardstick.hpp is held
/// against options.tolerance, and options.near is not used; z is of one kind, w and q of another. Where z = 0 its
/// yardstick is the largest |q_i / W_ii|. Of infinitely many solutions the nearest one counts. If trying
/// every mode is beyond the effort, and the matrix is not positive definite, or with friction mu not below the bound of
/// contact/every_load.hpp, the verdict on a right solution is `undecided`: it may not be the only one.
/// mistake_in(problem) is empty; `answer` has its size.
RecordJudgement judge_problem(const ContactProblem& problem, const ProblemAnswer& answer, const JudgeOptions& options);

}  // namespace slipproof
