// Unevaluated sums of two doubles, about 106 bits (Dekker; Hida, Li and Bailey): sums, products, quotients and roots
// with a relative error below `double_double_roundoff` each, underflow apart (Joldes, Muller and Popescu 2017 prove 3
// u^2, 5 u^2, 9.8 u^2 and 25/8 u^2 for these algorithms, u = 2^-53).
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace slipproof {

inline constexpr double double_double_roundoff = 0x1p-102;

struct DoubleDouble {
  double high = 0, low = 0;

  DoubleDouble() = default;
  DoubleDouble(double x) : high(x) {}  // NOLINT: numbers mix
  DoubleDouble(double h, double l) : high(h), low(l) {}

  /// |a| >= |b|, or a = 0.
  static DoubleDouble fast_sum(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
  }
  static DoubleDouble sum(double a, double b) {
    const double s = a + b, t = s - a;
    return {s, (a - (s - t)) + (b - t)};
  }
  static DoubleDouble product(double a, double b) {
    const double p = a * b;
    return {p, std::fma(a, b, -p)};
  }

  friend DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
    const DoubleDouble s = sum(x.high, y.high), t = sum(x.low, y.low);
    const DoubleDouble v = fast_sum(s.high, s.low + t.high);
    return fast_sum(v.high, v.low + t.low);
  }
  friend DoubleDouble operator-(const DoubleDouble& x) { return {-x.high, -x.low}; }
  friend DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + (-y); }
  friend DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
    const DoubleDouble p = product(x.high, y.high);
    const double cross = std::fma(x.high, y.low, std::fma(x.low, y.high, x.low * y.low));
    return fast_sum(p.high, p.low + cross);
  }
  friend DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
    const double t = 1 / y.high, rest = std::fma(-y.high, t, 1.0);
    const DoubleDouble inverse = fast_sum(t, t * (rest - y.low * t));
    const DoubleDouble h = x * inverse;  // and a step of Newton's method
    const DoubleDouble left = x - h * y;
    return h + left * inverse;
  }
  friend DoubleDouble sqrt(const DoubleDouble& x) {
    if (!(x.high > 0)) return {std::sqrt(x.high), 0};
    const double root = std::sqrt(x.high);
    const DoubleDouble rest = x - product(root, root);
    return fast_sum(root, rest.high / (2 * root));
  }
  DoubleDouble& operator+=(const DoubleDouble& y) { return *this = *this + y; }
  DoubleDouble& operator-=(const DoubleDouble& y) { return *this = *this - y; }
  DoubleDouble& operator*=(const DoubleDouble& y) { return *this = *this * y; }
  DoubleDouble& operator/=(const DoubleDouble& y) { return *this = *this / y; }
  friend bool operator==(const DoubleDouble& x, const DoubleDouble& y) { return x.high == y.high && x.low == y.low; }
  friend bool operator<(const DoubleDouble& x, const DoubleDouble& y) {
    return x.high < y.high || (x.high == y.high && x.low < y.low);
  }
  friend bool operator>(const DoubleDouble& x, const DoubleDouble& y) { return y < x; }
  friend bool operator<=(const DoubleDouble& x, const DoubleDouble& y) { return !(y < x); }
  friend bool operator>=(const DoubleDouble& x, const DoubleDouble& y) { return !(x < y); }
  friend DoubleDouble abs(const DoubleDouble& x) { return x.high < 0 ? -x : x; }
};

}  // namespace slipproof

namespace Eigen {
template <>
struct NumTraits<slipproof::DoubleDouble> : GenericNumTraits<slipproof::DoubleDouble> {
  using Real = slipproof::DoubleDouble;
  using NonInteger = slipproof::DoubleDouble;
  using Nested = slipproof::DoubleDouble;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 20,
    MulCost = 10
  };
};
}  // namespace Eigen
