// Conditions and numbers of claims in the syntax of statements, which has no `not`, no functions, no decimals, and no
// exponents below 1. The formula of a condition holds exactly where the condition is true: in a statement a comparison
// holds only where all its divisors differ from 0, and in a claim it has a value only there.
#pragma once

#include <string>

#include "base/expression/cases.hpp"

namespace slipproof {

/// The condition as a formula of a statement (proofs/statement/statement_text.hpp). Null if it would be too long: see
/// by_cases(), also for `defined`.
Expression formula_of(const Expression& truth, const OfExpression& defined = has_no_division);

/// A number without functions; null if it contains functions.
Expression written_number(const Expression& number, const OfExpression& defined = has_no_division);

/// `0 = 0`
Expression plainly_true();

/// The expression with decimals as quotients of whole numbers.
Expression with_quotients(const Expression& e);

/// Replaces characters that are not printable ASCII by ?, since statements are ASCII whatever the paper's file is
/// called.
std::string in_ascii(const std::string& text);

}  // namespace slipproof
