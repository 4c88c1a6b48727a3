// Equations of claims that are linear in the unknowns of the model and in the force: what follows from what.
#pragma once

#include <optional>
#include <vector>

#include "verify/solved_sample.hpp"

namespace slipproof {

/// The equations as rows; nothing if one has no value at the sample or is not linear.
std::optional<LinearRows> linear_rows(const CompiledSetting& setting, const std::vector<Rational>& values,
                                      const std::vector<Program>& equations);

/// Whether every row of `rows` follows from those of `given`.
bool follows(const LinearRows& rows, const LinearRows& given);

/// Whether `left`, its unknowns that do not occur in `right` eliminated, has the solutions of `right`.
bool equivalent(const LinearRows& left, const LinearRows& right);

}  // namespace slipproof
