// A small contact problem with an answer, in exact numbers.
#pragma once

#include <optional>

#include "contact/formats/json_problem.hpp"
#include "records/problems/problem_judge.hpp"
#include "records/record/cells.hpp"

namespace slipproof {

struct ProblemRecord {
  ContactProblem problem;
  ProblemAnswer answer;
  std::optional<NotFinite> not_finite;  ///< the first number of the answer that is NaN or infinite
};

/// Reads a problem from an object; not for large problems (JsonProblem::is_large). A decimal means the nearest binary64
/// unless `decimal_exact`. `line` is the text of `json`. Throws InputError.
ProblemRecord read_problem(const JsonProblem& json, std::string_view line, bool decimal_exact, bool ignore_unknown);

}  // namespace slipproof
