// Numbers of several scenes side by side, in vector registers.
#pragma once

#include <cmath>
#include <cstdint>

#include "filter/lane_numbers.hpp"

namespace slipproof {

// The vectors stay inside one function; their calling convention does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

typedef double Lanes __attribute__((vector_size(8 * lane_count)));
typedef std::int64_t LaneBits __attribute__((vector_size(8 * lane_count)));

inline LaneBits bits(const Lanes& x) {
  return reinterpret_cast<LaneBits>(x);
}
inline Lanes from_bits(const LaneBits& x) {
  return reinterpret_cast<Lanes>(x);
}
inline LaneBits sign_bit() {
  return bits(-Lanes{});  // of -0.0: 0.0 - 0.0 would be +0.0
}
inline Lanes absolute(const Lanes& x) {
  return from_bits(bits(x) & ~sign_bit());
}
inline Lanes load(const LaneNumbers& numbers) {
  return reinterpret_cast<const Lanes&>(numbers);
}
inline double absolute(double x) {
  return std::fabs(x);
}

}  // namespace slipproof
