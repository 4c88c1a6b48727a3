// The record of an answer to a small contact problem: is it the one solution?
#pragma once

#include "contact/judge/small.hpp"
#include "records/judging/judge.hpp"

namespace slipproof {

/// Translates a verdict on an answer to a contact problem into a verdict on a record. `certified`: a solution within
/// rho, or the only one; `inaccurate` includes eps-solutions; `wrong` includes problems without a solution, near the
/// answer or at all.
RecordVerdict record_verdict(ContactVerdict verdict);

/// Judges an answer by judge_small() with options.tolerance; ignores options.near. Requires that mistake_in(problem) is
/// empty and that `answer` has the size of the problem.
RecordJudgement judge_problem(const ContactProblem& problem, const ProblemAnswer& answer, const JudgeOptions& options);

}  // namespace slipproof
