// Polynomials with rational coefficients for the certificate checker, with limits on their size.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <map>
#include <stdexcept>

namespace slipproof::check {

// Limits that keep memory and time bounded whatever is read; proofs/FORMAT.md lists them.
inline constexpr std::size_t kMaxVariables = 64, kMaxTerms = 10'000, kMaxTermProducts = 200'000;
inline constexpr std::size_t kMaxCoefficientBits = 8'192;
inline constexpr int kMaxDegree = 255;  ///< in one variable

struct LimitError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Terms with coefficient zero are never stored, so equality of polynomials is equality of the maps.
class Polynomial {
 public:
  Polynomial() = default;
  explicit Polynomial(const mpq_class& constant) { add({}, constant); }
  static Polynomial variable(std::size_t index) {
    Polynomial result;
    Exponents exponents{};
    exponents.at(index) = 1;
    result.add(exponents, 1);
    return result;
  }
  bool is_zero() const { return terms_.empty(); }
  bool is_constant() const { return is_zero() || (terms_.size() == 1 && terms_.begin()->first == Exponents{}); }
  mpq_class constant() const { return is_zero() ? mpq_class(0) : terms_.begin()->second; }  ///< of a constant

  friend Polynomial operator+(Polynomial x, const Polynomial& y) {
    for (const auto& [exponents, coefficient] : y.terms_) x.add(exponents, coefficient);
    return x;
  }
  friend Polynomial operator*(const Polynomial& x, const Polynomial& y) {
    if (x.terms_.size() * y.terms_.size() > kMaxTermProducts) throw LimitError("a product has too many terms");
    Polynomial result;
    for (const auto& [left, p] : x.terms_) {
      for (const auto& [right, q] : y.terms_) {
        Exponents sum{};
        for (std::size_t i = 0; i < kMaxVariables; ++i) {
          if (left[i] + right[i] > kMaxDegree) throw LimitError("a degree is too large");
          sum[i] = static_cast<std::uint8_t>(left[i] + right[i]);
        }
        result.add(sum, p * q);
      }
    }
    return result;
  }
  Polynomial operator-() const { return Polynomial(mpq_class(-1)) * *this; }
  bool operator==(const Polynomial& other) const { return terms_ == other.terms_; }
  Polynomial power(unsigned exponent) const {
    Polynomial result(mpq_class(1));
    while (exponent-- > 0) result = result * *this;
    return result;
  }

 private:
  using Exponents = std::array<std::uint8_t, kMaxVariables>;

  void add(const Exponents& exponents, const mpq_class& coefficient) {
    mpq_class& sum = terms_[exponents];
    sum += coefficient;
    if (mpz_sizeinbase(sum.get_num_mpz_t(), 2) + mpz_sizeinbase(sum.get_den_mpz_t(), 2) > kMaxCoefficientBits) {
      throw LimitError("a coefficient has too many digits");
    }
    if (sum == 0) terms_.erase(exponents);
    if (terms_.size() > kMaxTerms) throw LimitError("a polynomial has too many terms");
  }

  std::map<Exponents, mpq_class> terms_;
};

}  // namespace slipproof::check
