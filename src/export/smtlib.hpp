// Statements for SMT solvers: a second opinion on what a certificate proves.
#pragma once

#include <string>

namespace slipproof {

/// The negation of the statement in `text`, the content of `file`, as SMT-LIB 2: `unsat` confirms the statement, `sat`
/// contradicts it. In the normal form of proofs/FORMAT.md, so without division, each sign condition scaled to integer
/// coefficients; the statement stands in comments. Without `exists` the logic is QF_NRA; with it NRA, as the negation
/// is that for some values of the variables all values of the unknowns violate the conclusion. Throws InputError.
std::string smtlib_text(const std::string& file, const std::string& text);

}  // namespace slipproof
