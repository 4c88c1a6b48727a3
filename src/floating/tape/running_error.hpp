// A binary64 number with a running bound on its error, at several points side by side.
//
// |value - exact| <= error after every operation, division included; MATHEMATICS.md derives the bounds. A number about
// which nothing is known has an infinite error, or NaN as its value or error. All questions below are then answered no.
#pragma once

#include <cmath>
#include <cstddef>

#include "base/rounding/running_bounds.hpp"
#include "floating/lanes/lane_vectors.hpp"

namespace slipproof {

// The vectors stay inside functions of this library, so their calling convention does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

/// Aligned for the widest registers: functions compiled for these expect it.
struct RunningError {
  alignas(sizeof(Lanes)) Lanes value{};
  alignas(sizeof(Lanes)) Lanes error{};
};

/// Takes lanes of `x` where the mask is set, lanes of `y` elsewhere.
inline Lanes chosen(const LaneBits& mask, const Lanes& x, const Lanes& y) {
  return from_bits((bits(x) & mask) | (bits(y) & ~mask));
}

// These functions do not compare numbers, because GCC splits a comparison into single lanes before it inlines them into
// functions for wide registers. They compare bits instead: the bits of numbers that are not negative have the order of
// the numbers, and NaN without its sign comes last.

/// Sets all bits of a lane if its first bit is set.
inline LaneBits spread(const LaneBits& sign) {
  return sign >> 63;
}
/// Whether a magnitude is not 0. For NaN the result has no meaning.
inline LaneBits not_zero(const Lanes& size) {
  return spread(LaneBits{} - bits(size));
}

/// The underflow term of a product or quotient: 0 if an operand is exactly 0.
inline Lanes underflow_unless_zero(const Lanes& size_of_x, const Lanes& size_of_y) {
  return from_bits(not_zero(size_of_x) & not_zero(size_of_y) & bits(Lanes{} + batch_underflow));
}

inline RunningError operator-(const RunningError& x) {
  return {-x.value, x.error};
}
inline RunningError operator+(const RunningError& x, const RunningError& y) {
  const Lanes value = x.value + y.value;
  return {value, (x.error + y.error + batch_rounding * absolute(value)) * bound_inflation};
}
inline RunningError operator-(const RunningError& x, const RunningError& y) {
  return x + -y;
}
inline RunningError operator*(const RunningError& x, const RunningError& y) {
  const Lanes value = x.value * y.value, size_x = absolute(x.value), size_y = absolute(y.value);
  const Lanes most_x = size_x + x.error, most_y = size_y + y.error;
  const Lanes propagated = size_x * y.error + x.error * most_y;
  const Lanes rounded = batch_rounding * absolute(value) + underflow_unless_zero(most_x, most_y);
  return {value, (propagated + rounded) * bound_inflation};
}
inline RunningError operator/(const RunningError& x, const RunningError& y) {
  const Lanes value = x.value / y.value, size_y = absolute(y.value), size = absolute(value);
  const Lanes least = size_y - y.error;
  const Lanes underflow = underflow_unless_zero(absolute(x.value) + x.error, Lanes{} + 1);
  const Lanes propagated = (x.error + size * y.error + underflow) / least;
  const Lanes error = (propagated + batch_rounding * size + underflow) * bound_inflation;
  // Where `least` is NaN, the error is NaN. `least` is never -0.0, which would compare as larger than 0 here.
  const LaneBits known = not_zero(least) & spread(bits(size_y) - bits(Lanes{} + batch_largest_divisor));
  return {value, chosen(known, error, Lanes{} + __builtin_inf())};
}

/// value > error, with both read as integers, where the value is neither negative nor NaN.
inline LaneBits surely_positive(const RunningError& x) {
  const LaneBits value = bits(absolute(x.value)), error = bits(absolute(x.error));
  const LaneBits infinite = bits(Lanes{} + __builtin_inf());
  return spread((error - value) & ~bits(x.value) & ~(infinite - value));
}
inline LaneBits surely_negative(const RunningError& x) {
  return surely_positive(-x);
}
inline LaneBits surely_not_zero(const RunningError& x) {
  return surely_positive({absolute(x.value), x.error});
}
inline LaneBits surely_zero(const RunningError& x) {
  return ~spread(LaneBits{} - (bits(absolute(x.value)) | bits(absolute(x.error))));
}
inline LaneBits surely_not_negative(const RunningError& x) {
  return surely_positive(x) | surely_zero(x);  // `value >= error` would be wrong: it holds where both are infinite
}

/// A number of one lane: itself if `exact`, or the nearest binary64 of what is meant; nothing is known of one that is
/// not finite.
inline void put_number(RunningError& number, std::size_t lane, double value, bool exact) {
  number.value[lane] = value;
  number.error[lane] = exact && std::isfinite(value) ? 0 : std::fabs(value) * batch_rounding + batch_underflow;
}

}  // namespace slipproof
