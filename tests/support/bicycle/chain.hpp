// The sprocket and the chain, for those who ask: no other result needs them.
#pragma once

#include "support/bicycle/bicycle.hpp"
#include "support/bicycle/contact_mode.hpp"

namespace slipproof {

template <class V>
struct Chain {
  V eps1;  ///< angular acceleration of the sprocket, 1/s^2
  V T;     ///< difference of the chain's tensions, N
};

/// From (eps1 - phi) r1 = (eps2 - phi) r2 and I1 eps1 = F L + T r1, (2.3) and (2.4).
template <class T, class V>
Chain<V> chain_of(const Bicycle<T>& p, const Motion<V>& m, const V& F) {
  const T mu = p.r2 / p.r1;
  const V eps1 = mu * m[Quantity::eps2] + T(1 - mu) * m[Quantity::phi];
  return {eps1, T(1 / p.r1) * (p.I1 * eps1 - p.L * F)};
}

}  // namespace slipproof
