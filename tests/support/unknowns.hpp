// From motions to the unknowns of model.md and back.
#pragma once

#include "model/equations.hpp"

namespace slipproof::test {

template <class V>
Motion<V> with_contacts(const Bicycle<Rational>& p, const Unknowns<V>& u) {
  return {{u.a, u.a_y, u.phi, u.eps2, u.eps3, u.S2, u.S3, u.N2, u.N3, gap(p, u, Wheel::rear), gap(p, u, Wheel::front),
           slip(p, u, Wheel::rear), slip(p, u, Wheel::front)}};
}

/// Unknowns of model.md from a motion: the sprocket's acceleration and the chain tension follow from the chain.
inline Unknowns<Rational> unknowns(const Bicycle<Rational>& p, const Rational& F, const Motion<Rational>& m) {
  const Rational mu = p.r2 / p.r1;
  const Rational eps1 = mu * m[Quantity::eps2] + (1 - mu) * m[Quantity::phi];
  return {m[Quantity::a],
          m[Quantity::a_y],
          m[Quantity::phi],
          eps1,
          m[Quantity::eps2],
          m[Quantity::eps3],
          (p.I1 * eps1 - F * p.L) / p.r1,
          m[Quantity::S2],
          m[Quantity::S3],
          m[Quantity::N2],
          m[Quantity::N3]};
}

}  // namespace slipproof::test
