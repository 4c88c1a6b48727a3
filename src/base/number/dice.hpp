// Random choices that are the same everywhere, for samples that depend on a seed and their number alone.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/number/rational.hpp"

namespace slipproof {

/// Generates the numbers of std::mt19937_64, but seeds its state only as needed: a sample takes a few dozen numbers,
/// and seeding all 312 words would take most of the time.
class Twister {
 public:
  explicit Twister(std::uint64_t seed) { state_[0] = seed; }

  std::uint64_t operator()() {
    if (seeded_ < size) seed_to(next_ + middle + 1);
    const std::size_t after = next_ + 1 == size ? 0 : next_ + 1;
    const std::uint64_t both = (state_[next_] & ~low_bits) | (state_[after] & low_bits);
    const std::uint64_t far = state_[next_ < size - middle ? next_ + middle : next_ + middle - size];
    std::uint64_t x = far ^ both >> 1 ^ ((0 - (both & 1U)) & 0xB5026F5AA96619E9U);
    state_[next_] = x;
    next_ = after;
    x ^= x >> 29 & 0x5555555555555555U;
    x ^= x << 17 & 0x71D67FFFEDA60000U;
    x ^= x << 37 & 0xFFF7EEE000000000U;
    return x ^ x >> 43;
  }

 private:
  static constexpr std::size_t size = 312, middle = 156;
  static constexpr std::uint64_t low_bits = 0x7FFFFFFFU;

  void seed_to(std::size_t count) {
    for (; seeded_ < std::min(count, size); ++seeded_) {
      const std::uint64_t before = state_[seeded_ - 1];
      state_[seeded_] = 6364136223846793005U * (before ^ before >> 62) + seeded_;
    }
  }

  std::array<std::uint64_t, size> state_;
  std::size_t seeded_ = 1, next_ = 0;
};

/// The choices for sample i. The standard distributions are not the same everywhere.
class Dice {
 public:
  Dice(std::uint64_t seed, std::uint64_t i) : engine_(seed * 0x9E3779B97F4A7C15U + i * 0xD1B54A32D192ED03U + 1) {}
  int number(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(int one_in) { return number(1, one_in) == 1; }

 private:
  Twister engine_;
};

}  // namespace slipproof
