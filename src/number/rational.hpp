// Exact numbers. Every exact layer of slipproof computes with these two types and nothing else.
#pragma once

#include <boost/multiprecision/gmp.hpp>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "slipproof tells NaN and infinities from numbers and trusts rounding: compile without fast-math"
#endif

namespace slipproof {

/// Integer of any size (GMP).
using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
/// Rational number of any size in lowest terms (GMP); the denominator is always positive.
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

/// -1, 0 or +1.
inline int sign(const Integer& x) {
  return x.sign();
}
inline int sign(const Rational& x) {
  return x.sign();
}
inline int sign(double x) {
  return (x > 0) - (x < 0);
}

}  // namespace slipproof
