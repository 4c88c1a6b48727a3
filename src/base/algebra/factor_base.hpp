// The irreducible factors of polynomials that come one after another, as along one line of bicycles, where most have
// most of their factors in common.
//
// Each polynomial is first divided by the known factors. Thousands are known, few divide it, and long divisions would
// take most of the time. So a remainder modulo a prime is tested first: if f divides p, it does so modulo any prime.
// Example: modulo 2^61 - 1, t^2 - 1 has the remainder 1 by t^2 - 2, so no long division is needed. Most factors divide
// no other polynomial. A factor that has divided none, or too few of those tried, is dropped; the cofactor then still
// contains it and is factored with it, after which the factor is tried again. A factor that divides 1 polynomial in 200
// is kept, since a factorization costs as much as thousands of remainders.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <vector>

#include "base/algebra/integer_polynomial.hpp"

namespace slipproof {

class FactorBase {
 public:
  FactorBase();
  ~FactorBase();
  FactorBase(const FactorBase&) = delete;
  FactorBase& operator=(const FactorBase&) = delete;

  /// Adds the irreducible factors of a polynomial. What is left of it without the known factors is not factored if it
  /// does not matter.
  void add(const IntegerPolynomial& p, const std::function<bool(const IntegerPolynomial&)>& matters);

  /// Primitive.
  const std::set<IntegerPolynomial>& factors() const { return factors_; }
  /// Counts of long divisions, of remainders modulo the prime, and of factored polynomials.
  std::uint64_t divisions() const { return divisions_; }
  std::uint64_t remainders() const { return remainders_; }
  std::uint64_t factored() const { return factored_; }

 private:
  class Residue;  ///< a polynomial modulo the prime
  struct Known {
    const IntegerPolynomial* factor;
    std::unique_ptr<Residue> residue;
    std::uint64_t tried = 0, divided = 0;
  };

  IntegerPolynomial without_known(IntegerPolynomial p);
  void insert(IntegerPolynomial factor);

  std::set<IntegerPolynomial> factors_;
  std::vector<Known> known_;
  std::uint64_t divisions_ = 0, remainders_ = 0, factored_ = 0;
};

}  // namespace slipproof
