// The numbers that claims are evaluated with symbolically: polynomials in the parameters of a setting and the force,
// and their quotients in lowest terms.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "base/algebra/polynomial.hpp"
#include "base/expression/evaluate.hpp"
#include "base/expression/with_divisors.hpp"

namespace slipproof {

/// A polynomial, or an integer, which belongs to any ring: generic code writes 0 and 1 without knowing the ring.
class SymbolicNumber {
 public:
  SymbolicNumber(int constant = 0) : value_(constant) {}                         // NOLINT: integers belong
  SymbolicNumber(MultiPolynomial polynomial) : value_(std::move(polynomial)) {}  // NOLINT: so do polynomials

  bool is_zero() const;
  bool is_one() const;
  bool is_constant() const { return polynomial() == nullptr || polynomial()->is_constant(); }
  /// nullptr for an integer.
  const MultiPolynomial* polynomial() const { return std::get_if<MultiPolynomial>(&value_); }

  SymbolicNumber operator-() const;
  friend SymbolicNumber operator+(const SymbolicNumber& x, const SymbolicNumber& y);
  friend SymbolicNumber operator-(const SymbolicNumber& x, const SymbolicNumber& y) { return x + -y; }
  friend SymbolicNumber operator*(const SymbolicNumber& x, const SymbolicNumber& y);
  friend bool operator==(const SymbolicNumber& x, const SymbolicNumber& y) { return (x - y).is_zero(); }
  /// Divides both by their greatest common divisor and makes y monic. Leaves two integers unchanged. y must not be 0.
  friend void cancel(SymbolicNumber& x, SymbolicNumber& y);

 private:
  MultiPolynomial in(const PolynomialRing& ring) const;
  int integer() const { return std::get<int>(value_); }

  std::variant<int, MultiPolynomial> value_;
};

/// numerator / denominator in lowest terms with a monic denominator: two are equal iff both parts are.
struct ReducedFraction {
  SymbolicNumber numerator, denominator = 1;

  ReducedFraction(SymbolicNumber n = 0) : numerator(std::move(n)) {}  // NOLINT: polynomials belong
  ReducedFraction(SymbolicNumber n, SymbolicNumber d) : numerator(std::move(n)), denominator(std::move(d)) {
    cancel(numerator, denominator);
  }
  friend ReducedFraction operator+(const ReducedFraction& x, const ReducedFraction& y) {
    return {x.numerator * y.denominator + y.numerator * x.denominator, x.denominator * y.denominator};
  }
  friend ReducedFraction operator-(const ReducedFraction& x) { return {-x.numerator, x.denominator}; }
  friend ReducedFraction operator-(const ReducedFraction& x, const ReducedFraction& y) { return x + -y; }
  friend ReducedFraction operator*(const ReducedFraction& x, const ReducedFraction& y) {
    return {x.numerator * y.numerator, x.denominator * y.denominator};
  }
  friend ReducedFraction operator/(const ReducedFraction& x, const ReducedFraction& y) {
    return {x.numerator * y.denominator, x.denominator * y.numerator};
  }
};

/// A polynomial that vanishes where the divisor of the fraction does.
inline std::optional<MultiPolynomial> divisor_of(const ReducedFraction& x) {
  return x.numerator.is_constant() ? std::nullopt : std::optional(*x.numerator.polynomial());
}
using SymbolicValue = WithDivisors<ReducedFraction, MultiPolynomial>;

/// Fractions can be equal or not; their order is never decided. The ring must outlive it.
struct FractionField {
  const PolynomialRing* ring;
  SymbolicValue constant(const Rational& value) const {
    return ReducedFraction(SymbolicNumber(MultiPolynomial(*ring, value)));
  }
  bool is_zero(const SymbolicValue& x) const { return x.value().numerator.is_zero(); }
  std::optional<int> compare(const SymbolicValue& x, const SymbolicValue& y) const {
    return (x.value() - y.value()).numerator.is_zero() ? std::optional(0) : std::nullopt;
  }
};
using SymbolicEvaluator = Evaluator<SymbolicValue, FractionField>;

/// A ring whose variables have the names of these slots of the scope, in this order.
std::unique_ptr<const PolynomialRing> ring_of(const Scope& scope, const std::vector<std::size_t>& slots);

/// An evaluator in which these slots are the variables of the ring. The ring must outlive it and all its results.
SymbolicEvaluator symbolic(const Scope& scope, const std::vector<std::size_t>& slots, const PolynomialRing& ring);

}  // namespace slipproof
