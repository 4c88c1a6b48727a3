// Polynomials in the parameters of a setting and the force, over FLINT, and their quotients in lowest terms.
#pragma once

#include <flint/fmpq_mpoly.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "expression/evaluate.hpp"
#include "expression/with_divisors.hpp"

namespace slipproof {

/// The variables are those of a scope, by slot.
class PolynomialRing {
 public:
  explicit PolynomialRing(std::size_t variables) {
    fmpq_mpoly_ctx_init(context_, static_cast<slong>(variables), ORD_DEGREVLEX);
  }
  ~PolynomialRing() { fmpq_mpoly_ctx_clear(context_); }
  PolynomialRing(const PolynomialRing&) = delete;
  PolynomialRing& operator=(const PolynomialRing&) = delete;
  fmpq_mpoly_ctx_struct* context() { return context_; }

 private:
  fmpq_mpoly_ctx_t context_;
};

/// A polynomial; an integer becomes one of any ring.
class MultiPolynomial {
 public:
  MultiPolynomial(int constant = 0) : constant_(constant) {}  // NOLINT: integers belong
  MultiPolynomial(std::shared_ptr<PolynomialRing> ring, const Rational& constant);
  static MultiPolynomial variable(std::shared_ptr<PolynomialRing> ring, std::size_t index);
  MultiPolynomial(const MultiPolynomial& other);
  MultiPolynomial(MultiPolynomial&& other) noexcept;
  MultiPolynomial& operator=(MultiPolynomial other) noexcept;
  ~MultiPolynomial();

  bool is_zero() const;
  bool is_constant() const;
  bool is_monic_constant() const;  ///< it is 1
  /// All coefficients are of one sign.
  bool is_one_signed() const;
  /// As an expression in these names, by variable.
  std::string text(const std::vector<std::string>& names) const;
  /// Its irreducible factors, constants left out.
  std::vector<MultiPolynomial> factors() const;
  /// Whether the variable occurs.
  bool has(std::size_t variable) const;
  MultiPolynomial operator-() const;
  friend bool operator==(const MultiPolynomial& x, const MultiPolynomial& y) { return (x - y).is_zero(); }
  friend MultiPolynomial operator+(const MultiPolynomial& x, const MultiPolynomial& y);
  friend MultiPolynomial operator-(const MultiPolynomial& x, const MultiPolynomial& y) { return x + -y; }
  friend MultiPolynomial operator*(const MultiPolynomial& x, const MultiPolynomial& y);
  /// Divides both by their greatest common divisor; y becomes monic. y must not be 0.
  friend void cancel(MultiPolynomial& x, MultiPolynomial& y);

 private:
  MultiPolynomial in(const std::shared_ptr<PolynomialRing>& ring) const;
  explicit MultiPolynomial(std::shared_ptr<PolynomialRing> ring);

  std::shared_ptr<PolynomialRing> ring_;  ///< none: `constant_`
  int constant_ = 0;
  fmpq_mpoly_t value_{};
};

/// numerator / denominator in lowest terms, the denominator monic: equal iff both parts are.
struct Fraction {
  MultiPolynomial numerator, denominator = 1;

  Fraction(MultiPolynomial n = 0) : numerator(std::move(n)) {}  // NOLINT: polynomials belong
  Fraction(MultiPolynomial n, MultiPolynomial d) : numerator(std::move(n)), denominator(std::move(d)) {
    cancel(numerator, denominator);
  }
  friend Fraction operator+(const Fraction& x, const Fraction& y) {
    return {x.numerator * y.denominator + y.numerator * x.denominator, x.denominator * y.denominator};
  }
  friend Fraction operator-(const Fraction& x) { return {-x.numerator, x.denominator}; }
  friend Fraction operator-(const Fraction& x, const Fraction& y) { return x + -y; }
  friend Fraction operator*(const Fraction& x, const Fraction& y) {
    return {x.numerator * y.numerator, x.denominator * y.denominator};
  }
  friend Fraction operator/(const Fraction& x, const Fraction& y) {
    return {x.numerator * y.denominator, x.denominator * y.numerator};
  }
};

/// What vanishes where a fraction does.
inline std::optional<MultiPolynomial> divisor_of(const Fraction& x) {
  return x.numerator.is_constant() ? std::nullopt : std::optional(x.numerator);
}
using SymbolicValue = WithDivisors<Fraction, MultiPolynomial>;

/// Fractions are equal or not; order is decided for none.
struct FractionField {
  std::shared_ptr<PolynomialRing> ring;
  SymbolicValue constant(const Rational& value) const { return Fraction(MultiPolynomial(ring, value)); }
  bool is_zero(const SymbolicValue& x) const { return x.value().numerator.is_zero(); }
  std::optional<int> compare(const SymbolicValue& x, const SymbolicValue& y) const {
    return (x.value() - y.value()).numerator.is_zero() ? std::optional(0) : std::nullopt;
  }
};
using SymbolicEvaluator = Evaluator<SymbolicValue, FractionField>;

/// An evaluator whose parameters and force are variables.
SymbolicEvaluator symbolic(const Scope& scope, std::size_t first, std::size_t count);

}  // namespace slipproof
