// Integers of a fixed number of bits, for formulas whose results are known to fit before they are computed: no memory,
// no branches on sizes.
#pragma once

#include <flint/fmpz.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>

#include "base/number/integer.hpp"

namespace slipproof {

/// What is known about the size of an integer: with 0 bits it is 0, otherwise its absolute value is below 2^bits. Ring
/// formulas evaluated on bit lengths give the bit lengths of their results.
struct BitLength {
  std::size_t bits = 0;

  BitLength() = default;
  explicit BitLength(int x) : bits(std::bit_width(x < 0 ? -static_cast<unsigned>(x) : static_cast<unsigned>(x))) {}
  explicit BitLength(const Integer& x) : bits(x.bits()) {}

  friend BitLength operator*(BitLength x, BitLength y) { return of(x.bits == 0 || y.bits == 0 ? 0 : x.bits + y.bits); }
  friend BitLength operator+(BitLength x, BitLength y) {
    return of(std::max(x.bits, y.bits) + (x.bits == 0 || y.bits == 0 ? 0 : 1));
  }
  friend BitLength operator-(BitLength x, BitLength y) { return x + y; }
  friend BitLength operator-(BitLength x) { return x; }

 private:
  static BitLength of(std::size_t bits) {
    BitLength length;
    length.bits = bits;
    return length;
  }
};

/// An integer modulo 2^(64 limbs), read as the representative nearest to 0 (of two, the negative one). Sums,
/// differences and products are correct if the result fits, even if intermediate values did not.
template <std::size_t limbs>
class FixedInteger {
  __extension__ using Double = unsigned __int128;

 public:
  /// x| must be below 2^value_bits.
  static constexpr std::size_t value_bits = 64 * limbs - 1;

  FixedInteger() = default;
  explicit FixedInteger(int x) {
    limbs_.fill(x < 0 ? ~std::uint64_t{0} : 0);
    limbs_[0] = static_cast<std::uint64_t>(x);
  }
  explicit FixedInteger(const Integer& x) { fmpz_get_signed_ui_array(limbs_.data(), limbs, x.flint()); }
  explicit operator Integer() const {
    if (is_long()) return Integer(static_cast<long>(limbs_[0]));
    Integer x;
    fmpz_set_signed_ui_array(x.flint(), limbs_.data(), limbs);
    return x;
  }

  bool is_zero() const {
    std::uint64_t any = 0;
    for (const std::uint64_t limb : limbs_) any |= limb;
    return any == 0;
  }
  /// -1, 0 or +1.
  int sign() const { return is_negative() ? -1 : is_zero() ? 0 : 1; }

  friend bool operator==(const FixedInteger& x, const FixedInteger& y) { return (x - y).is_zero(); }
  friend FixedInteger operator+(const FixedInteger& x, const FixedInteger& y) {
    FixedInteger sum;
    Double carry = 0;
    for (std::size_t i = 0; i < limbs; ++i) {
      carry += static_cast<Double>(x.limbs_[i]) + y.limbs_[i];
      sum.limbs_[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return sum;
  }
  friend FixedInteger operator-(const FixedInteger& x, const FixedInteger& y) {
    FixedInteger difference;
    Double borrow = 0;
    for (std::size_t i = 0; i < limbs; ++i) {
      borrow = static_cast<Double>(x.limbs_[i]) - y.limbs_[i] - borrow;
      difference.limbs_[i] = static_cast<std::uint64_t>(borrow);
      borrow >>= 127;
    }
    return difference;
  }
  friend FixedInteger operator-(const FixedInteger& x) { return FixedInteger() - x; }
  friend FixedInteger operator*(const FixedInteger& x, const FixedInteger& y) {
    FixedInteger product;
    for (std::size_t i = 0; i < limbs; ++i) {
      Double carry = 0;
      for (std::size_t j = 0; i + j < limbs; ++j) {
        carry += static_cast<Double>(x.limbs_[i]) * y.limbs_[j] + product.limbs_[i + j];
        product.limbs_[i + j] = static_cast<std::uint64_t>(carry);
        carry >>= 64;
      }
    }
    return product;
  }

  /// Of any two numbers, with all bits.
  friend FixedInteger<2 * limbs> long_product(const FixedInteger& x, const FixedInteger& y) {
    FixedInteger<2 * limbs> product;
    for (std::size_t i = 0; i < limbs; ++i) {
      Double carry = 0;
      for (std::size_t j = 0; j < limbs; ++j) {
        carry += static_cast<Double>(x.limbs_[i]) * y.limbs_[j] + product.limbs_[i + j];
        product.limbs_[i + j] = static_cast<std::uint64_t>(carry);
        carry >>= 64;
      }
      product.limbs_[i + limbs] = static_cast<std::uint64_t>(carry);
    }
    if (x.is_negative()) product.subtract_above(y);
    if (y.is_negative()) product.subtract_above(x);
    return product;
  }
  /// The greatest common divisor, at least 0.
  friend FixedInteger gcd(FixedInteger x, FixedInteger y) {
    if (x.is_negative()) x = -x;
    if (y.is_negative()) y = -y;
    if (x.is_zero()) return y;
    if (y.is_zero()) return x;
    const std::size_t x_twos = x.trailing_zeros(), y_twos = y.trailing_zeros();
    x = x.shifted_right(x_twos);
    y = y.shifted_right(y_twos);
    std::size_t x_size = x.size(), y_size = y.size();
    if (x_size < y_size) {
      std::swap(x, y);
      std::swap(x_size, y_size);
    }
    FixedInteger odd;
    mpn_gcd(odd.limbs_.data(), x.limbs_.data(), static_cast<mp_size_t>(x_size), y.limbs_.data(),
            static_cast<mp_size_t>(y_size));
    return odd.shifted_left(std::min(x_twos, y_twos));
  }
  /// Divides numbers by y, which divides all of them and is not 0. Modulo a power of two an odd number has an inverse.
  friend void divide_exactly(std::initializer_list<FixedInteger*> numbers, const FixedInteger& y) {
    const std::size_t twos = y.trailing_zeros();
    const FixedInteger inverse = y.shifted_right(twos).inverse_of_odd();
    for (FixedInteger* x : numbers) *x = x->shifted_right(twos) * inverse;
  }

 private:
  template <std::size_t other>
  friend class FixedInteger;

  bool is_negative() const { return limbs_.back() >> 63 != 0; }
  bool is_long() const {
    const std::uint64_t above = limbs_[0] >> 63 != 0 ? ~std::uint64_t{0} : 0;
    std::uint64_t differ = 0;
    for (std::size_t i = 1; i < limbs; ++i) differ |= limbs_[i] ^ above;
    return differ == 0;
  }
  /// How many limbs there are up to the last that is not 0.
  std::size_t size() const {
    std::size_t n = limbs;
    while (n > 0 && limbs_[n - 1] == 0) --n;
    return n;
  }
  /// Of a number that is not 0.
  std::size_t trailing_zeros() const {
    std::size_t i = 0;
    while (limbs_[i] == 0) ++i;
    return 64 * i + static_cast<std::size_t>(std::countr_zero(limbs_[i]));
  }
  /// Rounded down.
  FixedInteger shifted_right(std::size_t bits) const {
    const std::uint64_t above = is_negative() ? ~std::uint64_t{0} : 0;
    const auto limb = [&](std::size_t i) { return i < limbs ? limbs_[i] : above; };
    FixedInteger result;
    for (std::size_t i = 0; i < limbs; ++i) {
      const Double both = static_cast<Double>(limb(i + bits / 64 + 1)) << 64 | limb(i + bits / 64);
      result.limbs_[i] = static_cast<std::uint64_t>(both >> bits % 64);
    }
    return result;
  }
  FixedInteger shifted_left(std::size_t bits) const {
    FixedInteger result;
    for (std::size_t i = bits / 64; i < limbs; ++i) {
      const std::size_t from = i - bits / 64;
      const Double both = static_cast<Double>(limbs_[from]) << 64 | (from > 0 ? limbs_[from - 1] : 0);
      result.limbs_[i] = static_cast<std::uint64_t>((both << bits % 64) >> 64);
    }
    return result;
  }
  /// Newton iteration. An odd number is its own inverse modulo 8, so it starts with 3 correct bits; each step doubles
  /// them.
  FixedInteger inverse_of_odd() const {
    std::uint64_t low = limbs_[0];
    for (int right = 3; right < 64; right *= 2) low *= 2 - limbs_[0] * low;
    FixedInteger inverse;
    inverse.limbs_[0] = low;
    for (std::size_t right = 1; right < limbs; right *= 2) inverse = inverse * (FixedInteger(2) - *this * inverse);
    return inverse;
  }
  /// x 2^(32 limbs), taken away.
  void subtract_above(const FixedInteger<limbs / 2>& x) {
    Double borrow = 0;
    for (std::size_t i = 0; i < limbs / 2; ++i) {
      std::uint64_t& limb = limbs_[i + limbs / 2];
      borrow = static_cast<Double>(limb) - x.limbs_[i] - borrow;
      limb = static_cast<std::uint64_t>(borrow);
      borrow >>= 127;
    }
  }

  std::array<std::uint64_t, limbs> limbs_{};
};

// The same of integers of any size, for code over either.
inline Integer long_product(const Integer& x, const Integer& y) {
  return x * y;
}
inline void divide_exactly(std::initializer_list<Integer*> numbers, const Integer& y) {
  for (Integer* x : numbers) *x = exact_quotient(*x, y);
}

}  // namespace slipproof
