// Numbers of several scenes side by side, in vector registers.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "floating/lanes/lane_numbers.hpp"

namespace slipproof {

// The vectors stay inside one function, so their calling convention does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

/// `width` numbers side by side, and their bits. If a register holds fewer, the compiler splits comparisons into single
/// ones; therefore functions that compare are compiled for the width of the registers (vector_kernel.hpp).
template <int width>
struct LaneTypes {
  typedef double Numbers __attribute__((vector_size(8 * width)));
  typedef std::int64_t Bits __attribute__((vector_size(8 * width)));
  typedef std::uint64_t Words __attribute__((vector_size(8 * width)));
  typedef std::int32_t Halves __attribute__((vector_size(8 * width)));  ///< lower and upper halves of Bits
};
template <class V>
using BitsOf = typename LaneTypes<sizeof(V) / 8>::Bits;
template <class V>
inline constexpr int width_of = sizeof(V) / 8;

using Lanes = LaneTypes<lane_count>::Numbers;
using LaneBits = LaneTypes<lane_count>::Bits;

inline double absolute(double x) {
  return std::fabs(x);
}
template <class V>
inline BitsOf<V> bits(const V& x) {
  return reinterpret_cast<BitsOf<V>>(x);
}
template <class B>
inline auto from_bits(const B& x) {
  return reinterpret_cast<typename LaneTypes<sizeof(B) / 8>::Numbers>(x);
}
template <class V>
inline BitsOf<V> sign_bit() {
  return bits(-V{});  // the sign of -0.0, since 0.0 - 0.0 would be +0.0
}
template <class V>
inline V absolute(const V& x) {
  return from_bits(BitsOf<V>(bits(x) & ~sign_bit<V>()));
}
/// The same number in every lane, made from its bits: from the number, GCC would add it to 0.0.
template <class V>
inline V in_all_lanes(double x) {
  return from_bits(BitsOf<V>(BitsOf<V>{} + std::bit_cast<std::int64_t>(x)));
}
/// Negative where a number is NaN, or larger in magnitude than `limit` >= 0. Magnitudes have the same order when they
/// are read as integers, and NaN comes last.
template <class V>
inline BitsOf<V> beyond(const V& x, double limit) {
  return bits(in_all_lanes<V>(limit)) - bits(absolute(x));
}
inline Lanes load(const LaneNumbers& numbers) {
  return reinterpret_cast<const Lanes&>(numbers);
}
/// As many numbers as V has, starting at the given one.
template <class V>
inline V load(const double* numbers) {
  V x;
  std::memcpy(&x, numbers, sizeof x);
  return x;
}

}  // namespace slipproof
