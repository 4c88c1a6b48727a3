// Statements for SMT solvers: a second opinion on what a certificate proves.
#pragma once

#include <string>

namespace slipproof {

/// The negation of the statement in `text`, the content of `file`, as SMT-LIB 2: `unsat` confirms the statement, `sat`
/// contradicts it. In the normal form of proofs/FORMAT.md, so without division; each sign condition is scaled to
/// integer coefficients. The statement itself is included as comments. Without `exists` the logic is QF_NRA. With
/// `exists` it is NRA, as the negation says that for some values of the variables all values of the unknowns violate
/// the conclusion. Throws InputError.
std::string smtlib_text(const std::string& file, const std::string& text);

/// A statement with `exists` for the values that its certificate gives first, without a quantifier (QF_NRA): that for
/// some values of the variables a divisor of these values is zero or they violate the conclusion. `unsat` confirms the
/// statement, and `sat` contradicts the certificate. Empty where the certificate gives values in branches only, or
/// none. Throws InputError.
std::string smtlib_witness_text(const std::string& file, const std::string& text, const std::string& certificate_file,
                                const std::string& certificate);

}  // namespace slipproof
