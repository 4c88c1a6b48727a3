// About 100 bits from two binary64, without fused multiply-add: the number type of the second tier.
#pragma once

#include <cmath>

#include "base/number/binary64.hpp"
#include "floating/filter/bounds.hpp"

namespace slipproof {

/// An unevaluated sum high + low with |low| <= ulp(high) / 2.
struct DoubleDouble {
  double high = 0, low = 0;
};

/// x + y = high + low exactly (Knuth).
inline DoubleDouble two_sum(double x, double y) {
  const double s = x + y;
  const double t = s - x;
  return {s, (x - (s - t)) + (y - t)};
}

/// The same for |x| >= |y| (Dekker).
inline DoubleDouble fast_two_sum(double x, double y) {
  const double s = x + y;
  return {s, y - (s - x)};
}

/// x y = high + low exactly, unless the product or a part of it underflows (Dekker, with Veltkamp's splitting). Right
/// only when compiled without contraction of a*b+c.
inline DoubleDouble two_product(double x, double y) {
  constexpr double splitter = 0x1p27 + 1;
  const double cx = splitter * x, cy = splitter * y;
  const double xh = cx - (cx - x), yh = cy - (cy - y);
  const double xl = x - xh, yl = y - yh;
  const double p = x * y;
  return {p, ((xh * yh - p) + xh * yl + xl * yh) + xl * yl};
}

/// Relative error below 3 u^2 (Joldes, Muller, Popescu: AccurateDWPlusDW).
inline DoubleDouble operator+(DoubleDouble x, DoubleDouble y) {
  const DoubleDouble s = two_sum(x.high, y.high), t = two_sum(x.low, y.low);
  const DoubleDouble v = fast_two_sum(s.high, s.low + t.high);
  return fast_two_sum(v.high, t.low + v.low);
}
/// Relative error below 7 u^2 (the same authors: DWTimesDW1).
inline DoubleDouble operator*(DoubleDouble x, DoubleDouble y) {
  const DoubleDouble p = two_product(x.high, y.high);
  return fast_two_sum(p.high, p.low + (x.high * y.low + x.low * y.high));
}

/// Tracked with a double-double value: |value - exact| <= error().
class TrackedDouble2 {
 public:
  TrackedDouble2() = default;
  explicit TrackedDouble2(int constant) : value_{double(constant), 0}, magnitude_(std::fabs(double(constant))) {}
  explicit TrackedDouble2(DoubleDouble input) : value_(input), magnitude_(std::fabs(input.high)) {}
  static TrackedDouble2 input(double exact) { return TrackedDouble2(DoubleDouble{exact, 0}); }
  /// Rounded to double-double, which counts as an operation; finite where nearest_binary64(x) is.
  static TrackedDouble2 input(const Rational& x) {
    const double high = nearest_binary64(x);
    return TrackedDouble2(DoubleDouble{high, nearest_binary64(x - to_rational(high))});
  }

  double value() const { return value_.high; }
  double low() const { return value_.low; }  ///< what value() lacks of the double-double
  double error() const {
    return magnitude_ * (error_roundings * double_double_roundoff) + double_double_underflow_error;
  }

  friend TrackedDouble2 operator+(const TrackedDouble2& x, const TrackedDouble2& y) {
    return {x.value_ + y.value_, x.magnitude_ + y.magnitude_};
  }
  friend TrackedDouble2 operator*(const TrackedDouble2& x, const TrackedDouble2& y) {
    return {x.value_ * y.value_, x.magnitude_ * y.magnitude_};
  }
  friend TrackedDouble2 operator-(const TrackedDouble2& x) {
    return {DoubleDouble{-x.value_.high, -x.value_.low}, x.magnitude_};
  }
  friend TrackedDouble2 operator-(const TrackedDouble2& x, const TrackedDouble2& y) { return x + -y; }

 private:
  TrackedDouble2(DoubleDouble value, double magnitude) : value_(value), magnitude_(magnitude) {}
  DoubleDouble value_;
  double magnitude_ = 0;
};

/// What is certain of the sign of the exact value: value() is within one rounding of the double-double, for which
/// error_roundings has room.
inline bool certainly_positive(const TrackedDouble2& x) {
  return x.value() > x.error();
}
inline bool certainly_negative(const TrackedDouble2& x) {
  return x.value() < -x.error();
}

}  // namespace slipproof
