#include "base/rounding/exact_sum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/number/binary64.hpp"

namespace slipproof {

namespace {

__extension__ using Wide = unsigned __int128;

/// |a| = mantissa 2^(exponent - 1075), subnormal or not.
struct Parts {
  std::uint64_t mantissa;
  int exponent;
  bool negative;
};

Parts parts_of(double a) {
  const auto bits = std::bit_cast<std::uint64_t>(a);
  const auto exponent = static_cast<int>((bits >> 52) & 0x7FFU);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  if (exponent == 0) return {fraction, 1, bits >> 63 != 0};
  return {fraction | (std::uint64_t{1} << 52), exponent, bits >> 63 != 0};
}

}  // namespace

void ExactSum::add(double a, double b) {
  if (a == 0 || b == 0) return;
  const Parts p = parts_of(a), q = parts_of(b);
  const bool negative = p.negative != q.negative;
  Wide product = static_cast<Wide>(p.mantissa) * q.mantissa;  // 106 bits
  const int place = p.exponent + q.exponent - 2 * 1075 - lowest;
  auto at = static_cast<std::size_t>(place / 32);
  const int shift = place % 32;
  first_ = std::min(first_, at);
  // The lowest digit takes 32 - shift bits of the product, the others 32.
  std::uint64_t part = (static_cast<std::uint64_t>(product) << shift) & 0xFFFFFFFFU;
  product >>= 32 - shift;
  while (true) {
    digit_[at++] += negative ? -static_cast<std::int64_t>(part) : static_cast<std::int64_t>(part);
    if (product == 0) break;
    part = static_cast<std::uint64_t>(product) & 0xFFFFFFFFU;
    product >>= 32;
  }
  last_ = std::max(last_, at);
}

Rational ExactSum::value() const {
  if (first_ >= last_) return 0;
  Integer sum = 0;
  for (std::size_t i = last_; i-- > first_;) sum = (sum << 32) + digit_[i];
  const int exponent = lowest + 32 * static_cast<int>(first_);
  if (exponent >= 0) return Rational(Integer(sum << static_cast<std::size_t>(exponent)));
  return Rational(sum, Integer(Integer(1) << static_cast<std::size_t>(-exponent)));
}

double ExactSum::nearest() const {
  if (first_ >= last_) return 0;
  std::array<std::int64_t, digits + 1> digit;  // of the absolute value, in [0, 2^32)
  const auto carry_up = [&](std::int64_t sign) {
    std::int64_t carry = 0;
    for (std::size_t i = first_; i < last_; ++i) {
      const std::int64_t sum = sign * digit_[i] + carry;
      digit[i] = sum & 0xFFFFFFFF;
      carry = sum >> 32;
    }
    return digit[last_] = carry;
  };
  const bool negative = carry_up(1) < 0;
  if (negative) carry_up(-1);
  std::size_t top = last_;
  while (top > first_ && digit[top] == 0) --top;
  if (digit[top] == 0) return 0;
  // Three digits have at least 65 bits; the last of them stands for all that is below.
  Wide leading = 0;
  for (std::size_t i = 0; i < 3; ++i)
    leading = (leading << 32) | static_cast<Wide>(top >= first_ + i ? digit[top - i] : 0);
  for (std::size_t i = first_; i + 2 < top; ++i) leading |= digit[i] != 0 ? 1 : 0;
  // Rounded in integers, whatever the rounding mode of the machine is.
  const int surplus = 64 - std::countl_zero(static_cast<std::uint64_t>(leading >> 64)) + 64 - 53;
  auto mantissa = static_cast<std::uint64_t>(leading >> surplus);
  const Wide rest = leading - (static_cast<Wide>(mantissa) << surplus), half = static_cast<Wide>(1) << (surplus - 1);
  if (rest > half || (rest == half && mantissa % 2 == 1)) ++mantissa;
  const double rounded = std::ldexp(static_cast<double>(mantissa), lowest + 32 * (static_cast<int>(top) - 2) + surplus);
  if (!(rounded > 0x1p-1020 && rounded < 0x1p1020)) return nearest_binary64(value());
  return negative ? -rounded : rounded;
}

}  // namespace slipproof
