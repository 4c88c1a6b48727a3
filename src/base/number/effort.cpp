#include "base/number/effort.hpp"

#include <algorithm>
#include <cmath>

namespace slipproof {

Work plus(Work x, Work y) {
  return x > unlimited - y ? unlimited : x + y;
}

Work times(Work x, Work y) {
  return y != 0 && x > unlimited / y ? unlimited : x * y;
}

std::size_t bit_count(const Integer& x) {
  return std::max<std::size_t>(x.bits(), 1);
}

std::size_t bit_count(const Rational& x) {
  return bit_count(numerator(x)) + bit_count(denominator(x));
}

Work product_work(std::size_t bits) {
  constexpr Work of_every_product = 16;
  const Work words = bits / 64 + 1;
  return plus(times(words, static_cast<Work>(std::sqrt(static_cast<double>(words)))), of_every_product);
}

}  // namespace slipproof
