// The domain of the parameters: the table of bicycle.hpp as one condition.
#pragma once

#include "support/bicycle/bicycle.hpp"

namespace slipproof {

/// Whether every parameter is inside of its domain.
template <class T>
bool in_domain(const Bicycle<T>& p, const Road<T>& road) {
  return p.M > 0 && p.R > 0 && p.h > -p.R && p.b2 + p.b3 > 0 && p.I1 >= 0 && p.I2 >= 0 && p.I3 >= 0 && p.r1 > 0 &&
         p.r2 > 0 && (!p.J || *p.J > 0) && road.f >= 0 && road.g > 0;
}

}  // namespace slipproof
