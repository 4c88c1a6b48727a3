// Random choices that are the same everywhere, for samples that depend on a seed and their number alone.
#pragma once

#include <cstdint>
#include <random>

#include "number/rational.hpp"

namespace slipproof {

/// The choices for sample i. std::mt19937_64 is the same everywhere; the standard distributions are not.
class Dice {
 public:
  Dice(std::uint64_t seed, std::uint64_t i) : engine_(seed * 0x9E3779B97F4A7C15U + i * 0xD1B54A32D192ED03U + 1) {}
  int number(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(int one_in) { return number(1, one_in) == 1; }

 private:
  std::mt19937_64 engine_;
};

inline Rational power_of_two(int exponent) {
  const Integer power = Integer(1) << static_cast<unsigned>(exponent < 0 ? -exponent : exponent);
  return exponent < 0 ? Rational(Integer(1), power) : Rational(power);
}

}  // namespace slipproof
