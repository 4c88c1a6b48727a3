// Truth values of claims in the syntax of statements, which knows no `not`, `min`, `max` and no functions else.
#pragma once

#include <optional>
#include <string>

#include "claims/expression.hpp"

namespace slipproof {

/// Nothing where statements have no word for it.
std::optional<std::string> truth_text(const Expression& truth);

/// The opposite, wherever everything in it has a value: comparisons turned round, `and` and `or` exchanged.
Expression opposite(const Expression& truth);

}  // namespace slipproof
