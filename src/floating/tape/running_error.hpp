// binary64 beside a bound on its error that runs along with it, several points side by side.
//
// |value - exact| <= error, for every operation, division too; MATHEMATICS.md derives the bounds. What is not known has
// an infinite error, or NaN in one of both: all questions below are answered no then.
#pragma once

#include "base/rounding/running_bounds.hpp"
#include "floating/filter/lanes.hpp"

namespace slipproof {

// The vectors stay inside functions of this library; their calling convention does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

/// Aligned for the widest registers, which the compiler expects of it in the functions compiled for them.
struct RunningError {
  alignas(sizeof(Lanes)) Lanes value{};
  alignas(sizeof(Lanes)) Lanes error{};
};

/// Lanes of `x` where the mask is set, of `y` elsewhere.
inline Lanes chosen(const LaneBits& mask, const Lanes& x, const Lanes& y) {
  return from_bits((bits(x) & mask) | (bits(y) & ~mask));
}

/// What is added where a product or quotient is not of an exact 0.
inline Lanes underflow_unless_zero(const Lanes& size_of_x, const Lanes& size_of_y) {
  return from_bits((size_of_x > 0) & (size_of_y > 0) & bits(Lanes{} + batch_underflow));
}

inline RunningError operator-(const RunningError& x) {
  return {-x.value, x.error};
}
inline RunningError operator+(const RunningError& x, const RunningError& y) {
  const Lanes value = x.value + y.value;
  return {value, (x.error + y.error + batch_rounding * absolute(value)) * batch_slack};
}
inline RunningError operator-(const RunningError& x, const RunningError& y) {
  return x + -y;
}
inline RunningError operator*(const RunningError& x, const RunningError& y) {
  const Lanes value = x.value * y.value, size_x = absolute(x.value), size_y = absolute(y.value);
  const Lanes most_x = size_x + x.error, most_y = size_y + y.error;
  const Lanes propagated = size_x * y.error + x.error * most_y;
  const Lanes rounded = batch_rounding * absolute(value) + underflow_unless_zero(most_x, most_y);
  return {value, (propagated + rounded) * batch_slack};
}
inline RunningError operator/(const RunningError& x, const RunningError& y) {
  const Lanes value = x.value / y.value, size_y = absolute(y.value), size = absolute(value);
  const Lanes least = size_y - y.error;
  const Lanes underflow = underflow_unless_zero(absolute(x.value) + x.error, Lanes{} + 1);
  const Lanes propagated = (x.error + size * y.error + underflow) / least;
  const Lanes error = (propagated + batch_rounding * size + underflow) * batch_slack;
  const LaneBits known = (least > 0) & (size_y < batch_largest_divisor);
  return {value, chosen(known, error, Lanes{} + __builtin_inf())};
}

inline LaneBits surely_positive(const RunningError& x) {
  return x.value > x.error;
}
inline LaneBits surely_negative(const RunningError& x) {
  return x.value < -x.error;
}
inline LaneBits surely_not_zero(const RunningError& x) {
  return absolute(x.value) > x.error;
}
inline LaneBits surely_zero(const RunningError& x) {
  return (x.value == 0) & (x.error == 0);
}
inline LaneBits surely_not_negative(const RunningError& x) {
  return surely_positive(x) | surely_zero(x);  // not value >= error, which holds where both are infinite
}

}  // namespace slipproof
