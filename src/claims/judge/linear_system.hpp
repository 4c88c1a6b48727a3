// Equations of claims that are linear in the model's unknowns and the force, and what follows from them.
#pragma once

#include <optional>
#include <vector>

#include "claims/paper/compiled.hpp"
#include "mechanics/family/solved_sample.hpp"

namespace slipproof {

/// The equations as rows; nothing if an equation has no value at the sample or is not linear.
std::optional<LinearRows> linear_rows(const CompiledSetting& setting, const std::vector<Rational>& values,
                                      const std::vector<Program>& equations);

/// Whether some values of the unknowns and the force satisfy all rows.
bool has_solution(const LinearRows& rows);

/// Whether every row of `rows` follows from the rows of `given`; everything follows from a contradiction.
bool follows(const LinearRows& rows, const LinearRows& given);

/// Whether `left`, after eliminating the unknowns that do not occur on the right side, has the same solutions as
/// `right`. `occurs` is given by unknown, because a coefficient may vanish at a sample.
bool equivalent(const LinearRows& left, const LinearRows& right, const std::vector<bool>& occurs);

}  // namespace slipproof
