#include "base/rounding/exact_sum.hpp"

#include <algorithm>
#include <bit>

namespace slipproof {

namespace {

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
  __extension__ using Wide = unsigned __int128;
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

}  // namespace slipproof
