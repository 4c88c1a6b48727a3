#pragma once

#include <bit>
#include <cmath>
#include <random>

namespace slipproof::test {

/// Every finite binary64 is as likely as any other.
inline double random_finite(std::mt19937_64& random) {
  for (;;) {
    const auto x = std::bit_cast<double>(random());
    if (std::isfinite(x)) return x;
  }
}

}  // namespace slipproof::test
