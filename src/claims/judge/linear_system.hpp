// Equations of claims that are linear in the unknowns of the model and in the force: what follows from what.
#pragma once

#include <optional>
#include <vector>

#include "claims/sampling/solved_sample.hpp"

namespace slipproof {

/// The equations as rows; nothing if one has no value at the sample or is not linear.
std::optional<LinearRows> linear_rows(const CompiledSetting& setting, const std::vector<Rational>& values,
                                      const std::vector<Program>& equations);

/// Whether some values of the unknowns and the force meet all rows.
bool has_solution(const LinearRows& rows);

/// Whether every row of `rows` follows from those of `given`; from a contradiction everything does.
bool follows(const LinearRows& rows, const LinearRows& given);

/// Whether `left`, with the unknowns eliminated that do not occur on the right side, has the solutions of `right`.
/// `occurs` says it by unknown: a coefficient may vanish at a sample.
bool equivalent(const LinearRows& left, const LinearRows& right, const std::vector<bool>& occurs);

}  // namespace slipproof
