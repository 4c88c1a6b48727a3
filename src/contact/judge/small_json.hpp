// What is known of all solutions of a small problem, for programs: of a record in a line as of a file.
#pragma once

#include "base/output/json.hpp"
#include "contact/judge/small.hpp"

namespace slipproof {

/// The members `found`, one for each solution, and `continua`, if there are any, each with its point nearest to the
/// answer. All solutions must be known.
void add_solutions(const ContactProblem& problem, const SmallJudgement& found, Json& to);
/// Adds why the mode that the answer claims (`claimed`) or suggests (`looks_like`) fails: `violated`, `margin`,
/// `reason`. It must have been solved (`SmallJudgement::own`).
void add_own_mode(const ContactProblem& problem, const ProblemAnswer& answer, const SmallJudgement& found, Json& to);

/// ["slip+/stick", ...]
Json modes_json(const ContactProblem& problem, const std::vector<ProblemMode>& modes);

}  // namespace slipproof
