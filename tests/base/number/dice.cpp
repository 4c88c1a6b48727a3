#include "base/number/dice.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace slipproof;

TEST_CASE("a generator that is seeded as far as it is asked gives the numbers of the standard one") {
  for (const std::uint64_t seed : {0ULL, 1ULL, 5489ULL, 0x9E3779B97F4A7C15ULL, ~0ULL}) {
    std::mt19937_64 standard(seed);
    Twister twister(seed);
    for (int i = 0; i < 2000; ++i) CHECK(twister() == standard());
  }
}
