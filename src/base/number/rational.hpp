// Exact numbers. Every exact layer of slipproof computes with Integer and Rational and with nothing else.
#pragma once

#include <flint/fmpq.h>

#include <compare>
#include <concepts>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>

#include "base/number/integer.hpp"

namespace slipproof {

/// A rational number of any size in lowest terms; the denominator is always positive. Division throws
/// std::overflow_error for a divisor 0.
class Rational {
 public:
  Rational() = default;
  template <std::integral T>
  Rational(T x) : numerator_(x) {}                   // NOLINT: integers are rational
  Rational(Integer x) : numerator_(std::move(x)) {}  // NOLINT: so are these
  Rational(Integer dividend, Integer divisor);
  /// Reads the output of str(), of any length. Throws std::invalid_argument for any other text and std::overflow_error
  /// for the divisor 0. For input from people use parse_rational().
  explicit Rational(const std::string& text);
  /// Copies a number of FLINT or GMP, which must be in lowest terms.
  explicit Rational(const fmpq_t x) : numerator_(&x->num), denominator_(&x->den) {}
  explicit Rational(const mpq_t x) : numerator_(mpq_numref(x)), denominator_(mpq_denref(x)) {}

  /// The sign: -1, 0 or +1.
  int sign() const { return numerator_.sign(); }
  /// -1, 0 or +1 if this is less than, equal to or greater than y.
  int compare(const Rational& y) const {
    const int order = _fmpq_cmp(numerator_.flint(), denominator_.flint(), y.numerator_.flint(), y.denominator_.flint());
    return (order > 0) - (order < 0);
  }
  bool is_zero() const { return numerator_.is_zero(); }
  /// "3/4", "-5".
  std::string str() const;
  /// The binary64 that results from truncation towards 0.
  double to_double() const;
  explicit operator double() const { return to_double(); }  ///< for templates over number types

  Rational& operator+=(const Rational& y) {
    if (y.is_zero()) return *this;
    _fmpq_add(numerator_.flint(), denominator_.flint(), numerator_.flint(), denominator_.flint(), y.numerator_.flint(),
              y.denominator_.flint());
    return *this;
  }
  Rational& operator-=(const Rational& y) {
    if (y.is_zero()) return *this;
    _fmpq_sub(numerator_.flint(), denominator_.flint(), numerator_.flint(), denominator_.flint(), y.numerator_.flint(),
              y.denominator_.flint());
    return *this;
  }
  Rational& operator*=(const Rational& y) { return *this = *this * y; }
  Rational& operator/=(const Rational& y) { return *this = *this / y; }

  friend Rational operator-(Rational x) {
    x.numerator_.negate();
    return x;
  }
  friend Rational operator+(const Rational& x, const Rational& y) {
    Rational z;
    _fmpq_add(z.numerator_.flint(), z.denominator_.flint(), x.numerator_.flint(), x.denominator_.flint(),
              y.numerator_.flint(), y.denominator_.flint());
    return z;
  }
  friend Rational operator+(Rational&& x, const Rational& y) { return std::move(x += y); }
  friend Rational operator-(const Rational& x, const Rational& y) {
    Rational z;
    _fmpq_sub(z.numerator_.flint(), z.denominator_.flint(), x.numerator_.flint(), x.denominator_.flint(),
              y.numerator_.flint(), y.denominator_.flint());
    return z;
  }
  friend Rational operator-(Rational&& x, const Rational& y) { return std::move(x -= y); }
  friend Rational operator*(const Rational& x, const Rational& y) {
    Rational z;
    if (x.is_zero() || y.is_zero()) return z;  // half of the products in eliminations
    _fmpq_mul(z.numerator_.flint(), z.denominator_.flint(), x.numerator_.flint(), x.denominator_.flint(),
              y.numerator_.flint(), y.denominator_.flint());
    return z;
  }
  friend Rational operator/(const Rational& x, const Rational& y) {
    if (y.is_zero()) throw std::overflow_error("division by zero");
    Rational z;
    _fmpq_div(z.numerator_.flint(), z.denominator_.flint(), x.numerator_.flint(), x.denominator_.flint(),
              y.numerator_.flint(), y.denominator_.flint());
    return z;
  }
  friend bool operator==(const Rational& x, const Rational& y) = default;
  friend std::strong_ordering operator<=>(const Rational& x, const Rational& y) { return x.compare(y) <=> 0; }
  friend void swap(Rational& x, Rational& y) noexcept {
    swap(x.numerator_, y.numerator_);
    swap(x.denominator_, y.denominator_);
  }
  friend const Integer& numerator(const Rational& x);
  friend const Integer& denominator(const Rational& x);
  friend Integer numerator(Rational&& x);
  friend Integer denominator(Rational&& x);

  /// FLINT's representation, for functions that read it. Valid while the number lives and does not change.
  fmpq flint() const { return {*numerator_.flint(), *denominator_.flint()}; }

 private:
  Integer numerator_;
  Integer denominator_ = 1;
};

inline const Integer& numerator(const Rational& x) {
  return x.numerator_;
}
inline const Integer& denominator(const Rational& x) {
  return x.denominator_;
}
inline Integer numerator(Rational&& x) {
  return std::move(x.numerator_);
}
inline Integer denominator(Rational&& x) {
  return std::move(x.denominator_);
}
/// x 2^exponent.
Rational times_power_of_two(Integer x, long exponent);
Rational power_of_two(long exponent);
Rational abs(Rational x);
/// Throws std::overflow_error for 0 to a negative exponent.
Rational pow(const Rational& base, long exponent);
/// The square root if it is rational, otherwise nothing.
std::optional<Rational> exact_root(const Rational& x);
std::ostream& operator<<(std::ostream& out, const Rational& x);

/// A number in GMP's form, valid as long as this and the number live; read-only.
class GmpRational {
 public:
  explicit GmpRational(const Rational& x);
  mpq_srcptr get() const { return value_; }

 private:
  GmpInteger numerator_, denominator_;
  mpq_t value_;
};

inline int sign(const Rational& x) {
  return x.sign();
}

}  // namespace slipproof
