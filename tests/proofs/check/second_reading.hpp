// A second reading of certificates, for what the checker accepts although it looks like another proof. It shares no
// code with the checker: the prover reads the statement and its polynomials do the arithmetic, over FLINT.
#pragma once

#include <string>

namespace slipproof::test {

/// "" if the certificate proves the statement: each rule applies to hypotheses in force, and each identity holds.
/// Otherwise why that is not confirmed. Abbreviations of the statement are expanded.
std::string unconfirmed(const std::string& statement, const std::string& certificate);

}  // namespace slipproof::test
