// Exact numbers, and how they are written (FORMAT.md, first paragraph).
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <compare>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace slipproof::check_contact {

inline constexpr std::size_t kMaxDigits = 5'000;  ///< characters of a number
inline constexpr long kMaxExponent = 5'000;
inline constexpr std::size_t kMaxDenominator = 100'000;  ///< bits

/// The certificate does not prove its claim.
struct Rejected : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// n 2^e / d with d > 0. Floating point has d = 1: then sums and products need no greatest common divisor.
class Number {
 public:
  Number(long value = 0) : n_(value) {}
  Number(mpz_class n, long e, mpz_class d) : n_(std::move(n)), d_(std::move(d)), e_(e) { reduce(); }

  int sign() const { return sgn(n_); }
  mpz_class dividend() const { return e_ > 0 ? n_ << bits(e_) : n_; }
  mpz_class divisor() const { return e_ < 0 ? d_ << bits(-e_) : d_; }
  /// The largest integer that is not above 2^places times this.
  mpz_class floor(long places) const {
    const long up = e_ + places;
    mpz_class result = up < 0 ? mpz_class(n_ >> bits(-up)) : mpz_class(n_ << bits(up));
    mpz_fdiv_q(result.get_mpz_t(), result.get_mpz_t(), d_.get_mpz_t());
    return result;
  }

  Number& operator+=(Number y) {
    if (y.sign() == 0) return *this;
    if (sign() == 0) return *this = std::move(y);
    if (d_ != y.d_) {
      n_ *= y.d_;
      y.n_ *= d_;
      d_ *= y.d_;
    }
    if (e_ > y.e_) n_ <<= bits(e_ - y.e_);
    if (e_ < y.e_) y.n_ <<= bits(y.e_ - e_);
    e_ = std::min(e_, y.e_);
    n_ += y.n_;
    reduce();
    return *this;
  }
  Number operator-() const { return {-n_, e_, d_}; }
  friend Number operator+(Number x, Number y) { return x += std::move(y); }
  friend Number operator-(Number x, const Number& y) { return x += -y; }
  friend Number operator*(const Number& x, const Number& y) { return {x.n_ * y.n_, x.e_ + y.e_, x.d_ * y.d_}; }
  /// y != 0.
  friend Number operator/(const Number& x, const Number& y) {
    return {sgn(y.n_) * x.n_ * y.d_, x.e_ - y.e_, x.d_ * abs(y.n_)};
  }
  friend Number abs(const Number& x) { return x.sign() < 0 ? -x : x; }
  friend std::strong_ordering operator<=>(const Number& x, const Number& y) { return (x - y).sign() <=> 0; }
  friend bool operator==(const Number& x, const Number& y) { return (x - y).sign() == 0; }

 private:
  static mp_bitcnt_t bits(long count) { return static_cast<mp_bitcnt_t>(count); }

  void reduce() {
    if (d_ == 1) return;
    const mpz_class common = gcd(n_, d_);
    n_ /= common;
    d_ /= common;
    if (mpz_sizeinbase(d_.get_mpz_t(), 2) > kMaxDenominator) throw Rejected("a denominator exceeds 100000 bits");
  }

  mpz_class n_, d_ = 1;
  long e_ = 0;
};

inline Number square(const Number& x) {
  return x * x;
}

/// Digits and nothing else, at least one.
inline std::optional<mpz_class> natural(std::string_view text, int base = 10) {
  constexpr std::string_view digits = "0123456789abcdef";
  const std::string_view allowed = digits.substr(0, static_cast<std::size_t>(base));
  if (text.empty() || text.find_first_not_of(allowed) != std::string_view::npos) return {};
  return mpz_class(std::string(text), base);
}

/// `7` or `3/4`.
inline std::optional<Number> fraction(std::string_view text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto dividend = natural(text.substr(0, slash));
  const auto divisor = slash == text.size() ? mpz_class(1) : natural(text.substr(slash + 1));
  if (!dividend || !divisor || *divisor == 0) return {};
  return Number(*dividend, 0, *divisor);
}

/// What follows `0x`: `1.8p-3`, `1p+4`.
inline std::optional<Number> hexadecimal(std::string_view text) {
  const std::size_t p = std::min(text.find('p'), text.size());
  const std::size_t point = std::min(text.find('.'), p);
  std::string mantissa(text.substr(0, point));
  std::size_t places = 0;
  if (point < p) {
    places = p - point - 1;
    mantissa += text.substr(point + 1, places);
  }
  std::string_view power = text.substr(std::min(p + 1, text.size()));
  const bool negative = power.starts_with('-');
  if (negative || power.starts_with('+')) power.remove_prefix(1);
  const auto n = natural(mantissa, 16), e = natural(power);
  if (!n || !e || *e > kMaxExponent || point == 0 || (point < p && places == 0)) return {};
  return Number(*n, (negative ? -e->get_si() : e->get_si()) - 4 * static_cast<long>(places), 1);
}

inline std::optional<Number> number(std::string_view text) {
  if (text.size() > kMaxDigits) return {};
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  const auto value = text.starts_with("0x") ? hexadecimal(text.substr(2)) : fraction(text);
  return value && negative ? -*value : value;
}

/// In lowest terms: `-3/4`, or `7`.
inline std::string canonical(const Number& x) {
  mpq_class value(x.dividend(), x.divisor());
  value.canonicalize();
  return value.get_str();
}

/// Of x >= 0 two digits, rounded up: `1.3e-12`.
inline std::string decimal(const Number& x) {
  if (x.sign() == 0) return "0";
  mpz_class dividend = x.dividend(), divisor = x.divisor(), digits;
  long exponent = 1;
  for (; dividend > 99 * divisor; ++exponent) divisor *= 10;
  for (; dividend <= 9 * divisor; --exponent) dividend *= 10;
  mpz_cdiv_q(digits.get_mpz_t(), dividend.get_mpz_t(), divisor.get_mpz_t());
  const std::string shown = digits.get_str();
  return shown.substr(0, 1) + "." + shown.substr(1) + "e" + std::to_string(exponent);
}

}  // namespace slipproof::check_contact
