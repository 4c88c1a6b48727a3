// Integers of any size. FLINT's integers keep up to 62 bits in place of a pointer: most numbers here are short, and
// with an allocation for each, memory took half of the time.
#pragma once

#include <flint/fmpz.h>

#include <compare>
#include <concepts>
#include <cstddef>
#include <iosfwd>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "slipproof distinguishes NaN and infinities from numbers and relies on rounding: compile without fast-math"
#endif

namespace slipproof {

/// An integer of any size. Quotients are rounded toward zero and remainders have the sign of the dividend, as those of
/// int; both throw std::overflow_error for a divisor 0.
class Integer {
 public:
  Integer() = default;
  template <std::signed_integral T>
  Integer(T x) {                                // NOLINT: integers are integers
    if constexpr (sizeof(T) > sizeof(slong)) {  // of 64 bits where FLINT's words have 32
      const auto bits = static_cast<std::make_unsigned_t<T>>(x);
      *this = Integer(x < 0 ? -bits : bits);
      if (x < 0) negate();
    } else {
      fmpz_init_set_si(&value_, x);
    }
  }
  template <std::unsigned_integral T>
  Integer(T x) {  // NOLINT: so are these
    if constexpr (sizeof(T) > sizeof(ulong)) {
      fmpz_set_uiui(&value_, static_cast<ulong>(x >> FLINT_BITS), static_cast<ulong>(x));
    } else {
      fmpz_init_set_ui(&value_, x);
    }
  }
  /// Reads digits of base 10 or 16, with - before a negative number. Throws std::invalid_argument for any other text.
  explicit Integer(const std::string& digits, int base = 10);
  /// Copies a number of FLINT or GMP.
  explicit Integer(const fmpz_t x) { fmpz_init_set(&value_, x); }
  explicit Integer(const mpz_t x) { fmpz_set_mpz(&value_, x); }
  Integer(const Integer& other) { fmpz_init_set(&value_, &other.value_); }
  Integer(Integer&& other) noexcept : value_(std::exchange(other.value_, 0)) {}
  Integer& operator=(const Integer& other) {
    fmpz_set(&value_, &other.value_);
    return *this;
  }
  Integer& operator=(Integer&& other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  ~Integer() { fmpz_clear(&value_); }

  /// The sign: -1, 0 or +1.
  int sign() const { return is_short() ? (value_ > 0) - (value_ < 0) : fmpz_sgn(&value_); }
  /// -1, 0 or +1 if this is less than, equal to or greater than y.
  int compare(const Integer& y) const {
    const int order = fmpz_cmp(&value_, &y.value_);
    return (order > 0) - (order < 0);
  }
  bool is_zero() const { return value_ == 0; }
  bool is_one() const { return value_ == 1; }
  bool is_odd() const { return fmpz_is_odd(&value_) != 0; }
  /// The number of bits of |x|; 0 for 0.
  std::size_t bits() const { return fmpz_bits(&value_); }
  /// Whether to_long() can represent it.
  bool fits_long() const { return is_short() || fmpz_fits_si(&value_) != 0; }
  long to_long() const { return is_short() ? value_ : fmpz_get_si(&value_); }
  /// The binary64 that results from truncation towards 0.
  double to_double() const;
  /// Digits in base 10 or 16.
  std::string str(int base = 10) const;

  Integer& operator+=(const Integer& y) {
    fmpz_add(&value_, &value_, &y.value_);
    return *this;
  }
  Integer& operator-=(const Integer& y) {
    fmpz_sub(&value_, &value_, &y.value_);
    return *this;
  }
  Integer& operator*=(const Integer& y) {
    fmpz_mul(&value_, &value_, &y.value_);
    return *this;
  }
  Integer& operator/=(const Integer& y) {
    fmpz_tdiv_q(&value_, &value_, y.divisor());
    return *this;
  }
  Integer& operator%=(const Integer& y) {
    Integer quotient;
    fmpz_tdiv_qr(&quotient.value_, &value_, &value_, y.divisor());
    return *this;
  }
  Integer& operator<<=(std::size_t bits) {
    fmpz_mul_2exp(&value_, &value_, bits);
    return *this;
  }
  /// Rounded toward zero.
  Integer& operator>>=(std::size_t bits) {
    fmpz_tdiv_q_2exp(&value_, &value_, bits);
    return *this;
  }
  Integer& operator++() { return *this += 1; }
  Integer& operator--() { return *this -= 1; }
  /// x += a b and x -= a b.
  void add_product(const Integer& a, const Integer& b) { fmpz_addmul(&value_, &a.value_, &b.value_); }
  void subtract_product(const Integer& a, const Integer& b) { fmpz_submul(&value_, &a.value_, &b.value_); }
  void negate() { fmpz_neg(&value_, &value_); }

  friend Integer operator-(Integer x) {
    x.negate();
    return x;
  }
  friend Integer operator+(const Integer& x, const Integer& y) {
    Integer z;
    fmpz_add(&z.value_, &x.value_, &y.value_);
    return z;
  }
  friend Integer operator-(const Integer& x, const Integer& y) {
    Integer z;
    fmpz_sub(&z.value_, &x.value_, &y.value_);
    return z;
  }
  friend Integer operator*(const Integer& x, const Integer& y) {
    Integer z;
    fmpz_mul(&z.value_, &x.value_, &y.value_);
    return z;
  }
  friend Integer operator/(const Integer& x, const Integer& y) {
    Integer z;
    fmpz_tdiv_q(&z.value_, &x.value_, y.divisor());
    return z;
  }
  friend Integer operator%(Integer x, const Integer& y) { return x %= y; }
  friend Integer operator<<(Integer x, std::size_t bits) { return x <<= bits; }
  friend Integer operator>>(Integer x, std::size_t bits) { return x >>= bits; }
  friend bool operator==(const Integer& x, const Integer& y) { return fmpz_equal(&x.value_, &y.value_) != 0; }
  friend std::strong_ordering operator<=>(const Integer& x, const Integer& y) { return x.compare(y) <=> 0; }
  friend void swap(Integer& x, Integer& y) noexcept { std::swap(x.value_, y.value_); }

  /// A pointer to FLINT's representation, for calls of its functions.
  const fmpz* flint() const { return &value_; }
  fmpz* flint() { return &value_; }

 private:
  bool is_short() const { return !COEFF_IS_MPZ(value_); }
  const fmpz* divisor() const {
    if (is_zero()) throw std::overflow_error("division by zero");
    return &value_;
  }

  fmpz value_ = 0;
};

Integer abs(Integer x);
/// Greatest common divisor and least common multiple, at least 0.
Integer gcd(const Integer& x, const Integer& y);
Integer lcm(const Integer& x, const Integer& y);
Integer pow(const Integer& base, unsigned long exponent);
/// The root of a number that is not negative, rounded down.
Integer sqrt(const Integer& x);
/// The square root if x is a perfect square, otherwise nothing.
std::optional<Integer> exact_root(const Integer& x);
/// x / y where y divides x; y must not be 0.
Integer exact_quotient(const Integer& x, const Integer& y);
std::ostream& operator<<(std::ostream& out, const Integer& x);

struct QuotientAndRemainder {
  Integer quotient, remainder;
};
/// Computes x / y and x % y together.
QuotientAndRemainder divide(const Integer& x, const Integer& y);

/// A number in GMP's form, valid as long as this and the number live; read-only.
class GmpInteger {
 public:
  explicit GmpInteger(const Integer& x);
  GmpInteger(const GmpInteger&) = delete;
  GmpInteger& operator=(const GmpInteger&) = delete;
  mpz_srcptr get() const { return value_; }

 private:
  mpz_t value_;
  mp_limb_t limb_ = 0;
};

inline int sign(const Integer& x) {
  return x.sign();
}
inline int sign(double x) {
  return (x > 0) - (x < 0);
}

}  // namespace slipproof
