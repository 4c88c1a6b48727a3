// From a motion back to the unknowns of proofs/MODEL.md.
#pragma once

#include "support/bicycle/chain.hpp"
#include "support/bicycle/equations.hpp"

namespace slipproof::test {

inline Unknowns<Rational> unknowns(const Bicycle<Rational>& p, const Rational& F, const Motion<Rational>& m) {
  using enum Quantity;
  const Chain<Rational> chain = chain_of(p, m, F);
  return {m[a], m[a_y], m[phi], chain.eps1, m[eps2], m[eps3], chain.T, m[S2], m[S3], m[N2], m[N3]};
}

}  // namespace slipproof::test
