#include "number/effort.hpp"

#include <cmath>

namespace slipproof {

Work plus(Work x, Work y) {
  return x > endless - y ? endless : x + y;
}

Work times(Work x, Work y) {
  return y != 0 && x > endless / y ? endless : x * y;
}

std::size_t bit_count(const Integer& x) {
  return mpz_sizeinbase(x.backend().data(), 2);
}

std::size_t bit_count(const Rational& x) {
  const mpq_srcptr q = x.backend().data();
  return mpz_sizeinbase(mpq_numref(q), 2) + mpz_sizeinbase(mpq_denref(q), 2);
}

Work product_work(std::size_t bits) {
  constexpr Work of_every_product = 16;
  const Work words = bits / 64 + 1;
  return plus(times(words, static_cast<Work>(std::sqrt(static_cast<double>(words)))), of_every_product);
}

}  // namespace slipproof
