// Polynomials with integer coefficients.
#pragma once

#include <array>
#include <map>

#include "proofs/check/reader.hpp"

namespace slipproof::check {

inline constexpr std::size_t kMaxVariables = 64;
inline constexpr int kMaxDegree = 255;                 ///< in one variable
inline constexpr std::size_t kMaxProducts = 200'000;   ///< of terms, in a multiplication
inline constexpr std::size_t kMaxCoefficient = 128;    ///< words of 64 bits
inline constexpr std::size_t kWordsWork = 512;         ///< products of words that cost as much as a term
inline constexpr std::size_t kMaxCounted = 1'000'000;  ///< polynomials and terms at a time

/// Objects counted while they exist. Their number is bounded for every input, and so is the memory. Making one counts
/// as work.
class Counted {
 public:
  Counted() {
    require(count < kMaxCounted, "too many polynomials and terms");
    Work::spend(1);
    ++count;
  }
  Counted(const Counted&) : Counted() {}
  Counted(Counted&&) noexcept { ++count; }
  Counted& operator=(const Counted&) = default;
  ~Counted() { --count; }

 private:
  inline static thread_local std::size_t count = 0;
};

/// Of each variable in a term.
struct Exponents : Counted, std::array<std::uint8_t, kMaxVariables> {};

class Polynomial : Counted {
 public:
  Polynomial() = default;
  explicit Polynomial(const mpz_class& coefficient, const Exponents& exponents = {}) { add(exponents, coefficient); }
  bool is_zero() const { return terms_.empty(); }
  bool is_constant() const { return is_zero() || (terms_.size() == 1 && terms_.begin()->first == Exponents{}); }
  mpz_class constant() const { return is_zero() ? mpz_class(0) : terms_.begin()->second; }  ///< of a constant
  bool operator==(const Polynomial& other) const { return terms_ == other.terms_; }

  Polynomial& operator+=(Polynomial other) {
    terms_.merge(other.terms_);  // what stays behind are the terms that both have
    for (const auto& [exponents, coefficient] : other.terms_) add(exponents, coefficient);
    return *this;
  }

  friend Polynomial operator*(const Polynomial& x, const Polynomial& y) {
    require(x.terms_.size() * y.terms_.size() <= kMaxProducts, "a product has too many terms");
    Polynomial result;
    for (const auto& [left, p] : x.terms_) {
      for (const auto& [right, q] : y.terms_) {
        Work::spend(mpz_size(p.get_mpz_t()) * mpz_size(q.get_mpz_t()) / kWordsWork);
        result.add(sum(left, right), p * q);
      }
    }
    return result;
  }

  friend Polynomial operator-(Polynomial p) {
    for (auto& [exponents, coefficient] : p.terms_) coefficient = -coefficient;
    return p;
  }

 private:
  static Exponents sum(const Exponents& x, const Exponents& y) {
    Exponents result{};
    int too_large = 0;
    for (std::size_t i = 0; i < kMaxVariables; ++i) {
      too_large |= x[i] + y[i] > kMaxDegree;
      result[i] = static_cast<std::uint8_t>(x[i] + y[i]);
    }
    require(too_large == 0, "a degree is too large");
    return result;
  }

  void add(const Exponents& exponents, const mpz_class& coefficient) {
    const auto term = terms_.try_emplace(terms_.end(), exponents);  // most terms come in order
    mpz_class& sum = term->second;
    sum += coefficient;
    require(mpz_size(sum.get_mpz_t()) <= kMaxCoefficient, "a coefficient is too large");
    if (sum == 0) terms_.erase(term);
  }

  std::map<Exponents, mpz_class> terms_;  ///< no coefficient is zero, so equality is equality of the maps
};

}  // namespace slipproof::check
