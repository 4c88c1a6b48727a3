// The record of an answer to a small contact problem: is it the one solution?
#pragma once

#include "contact/judge/small.hpp"
#include "records/judging/judge.hpp"

namespace slipproof {

/// Which verdict on a record a verdict on an answer to a contact problem is. `certified` is a solution within rho or
/// the only one, `inaccurate` also an eps-solution, `wrong` also a problem without a solution, near the answer or at
/// all.
RecordVerdict record_verdict(ContactVerdict verdict);

/// By judge_small() with options.tolerance; options.near is not used. Requires that mistake_in(problem) is empty and
/// that `answer` has the size of the problem.
RecordJudgement judge_problem(const ContactProblem& problem, const ProblemAnswer& answer, const JudgeOptions& options);

}  // namespace slipproof
