// Contact problems with an answer, one JSON object on each line.
#pragma once

#include <optional>
#include <string_view>

#include "records/problems/problem_judge.hpp"
#include "records/record/cells.hpp"

namespace slipproof {

struct ProblemRecord {
  ContactProblem problem;
  ProblemAnswer answer;
  std::optional<NotFinite> not_finite;  ///< the first number of the answer that is NaN or infinite
};

/// Whether a line is meant as a contact problem: it has a list under the key q, which a scene never has.
bool is_problem(std::string_view line);

/// Keys: W (or M), q, z; for friction mu, with a dimension of 2 or none; w and mode if the solver gives them. Values
/// are numbers, or texts in any form that scenes allow; a decimal means the nearest binary64 unless `decimal_exact`.
/// Throws BrokenRecord.
ProblemRecord read_problem(std::string_view line, bool decimal_exact, bool ignore_unknown);

}  // namespace slipproof
