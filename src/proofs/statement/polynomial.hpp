// The prover has no other polynomials than these, and calls them so for short.
#pragma once

#include "base/algebra/polynomial.hpp"

namespace slipproof::prove {

using Polynomial = MultiPolynomial;
using Ring = PolynomialRing;

}  // namespace slipproof::prove
