// States, as statements, that a statement is false at given numbers.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/number/rational.hpp"
#include "proofs/statement/statement_text.hpp"

namespace slipproof {

/// Values of the variables that a statement declares by `real`, in their order.
using NamedValues = std::vector<std::pair<std::string, Rational>>;

/// Two statements that together say that a statement, the content of NAME.statement, is false: NAME.refuted.met, that
/// its assumptions are met at the values, and NAME.refuted.fails, that its conclusion is false there, for all values of
/// the unknowns that it asks for. Throws InputError if the text is not a statement.
std::vector<NamedStatement> refutation_at(const NamedStatement& statement, const NamedValues& values);

/// The values in a text of NAME.refuted.met; nothing if it lacks a variable of the statement.
std::optional<NamedValues> refuting_values(const NamedStatement& statement, const std::string& met);

}  // namespace slipproof
