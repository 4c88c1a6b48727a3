// The irreducible factors of polynomials that come one after another, as along one line of bicycles, where most have
// most of their factors in common.
//
// Each polynomial is first divided by factors that are known. Of thousands few divide it, and long divisions cost most
// of the time, so remainders modulo a prime come first: if f divides p, it does so modulo any prime. Modulo 2^61 - 1,
// t^2 - 2 leaves the remainder 1 in t^2 - 1, so that it needs no long division. Most factors divide no other
// polynomial. A factor is no longer tried once it has divided none, or few for as often as it was tried: what is left
// then still has it, and is factored with it. Such a factor is tried again. One that divides 1 polynomial in 200 stays:
// to factor costs as much as thousands of remainders.
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
  /// How many long divisions there were, how many remainders modulo the prime, and how many polynomials were factored.
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
