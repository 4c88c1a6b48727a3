#include "proofs/branch/samples.hpp"

#include <cmath>
#include <random>

namespace slipproof::prove {

Samples::Samples(const Ring& ring, const std::vector<bool>& positive) : values_(ring.size()) {
  std::mt19937_64 random(20);  // its sequence is the same everywhere, that of the library's distributions is not
  for (std::size_t variable = 0; variable < values_.size(); ++variable) {
    for (double& value : values_[variable]) {
      const std::uint64_t draw = random();
      // From 1/8 to 8, as many below 1 as above.
      const double magnitude = static_cast<double>(8 + (draw >> 8) % 57) / 8;
      value = (draw & 1) != 0 ? magnitude : 1 / magnitude;
      if (!positive[variable] && (draw & 2) != 0) value = -value;
    }
  }
}

SignPattern Samples::signs(const Polynomial& p) const {
  Column sum{}, size{};
  for (const Term& term : p.terms()) {
    Column product;
    product.fill(term.coefficient.to_double());
    for (std::size_t variable = 0; variable < term.exponents.size(); ++variable) {
      for (unsigned long k = 0; k < term.exponents[variable]; ++k) {
        for (std::size_t i = 0; i < kSamples; ++i) product[i] *= values_[variable][i];
      }
    }
    for (std::size_t i = 0; i < kSamples; ++i) {
      sum[i] += product[i];
      size[i] += std::abs(product[i]);
    }
  }
  SignPattern result;
  for (std::size_t i = 0; i < kSamples; ++i) {
    if (!(std::abs(sum[i]) > 1e-9 * size[i])) continue;
    (sum[i] > 0 ? result.positive : result.negative).insert(i);
  }
  return result;
}

}  // namespace slipproof::prove
