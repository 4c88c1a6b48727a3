// Polynomials in the parameters of a setting and the force, over FLINT, and their quotients in lowest terms.
#pragma once

#include <flint/fmpq_mpoly.h>

#include <memory>
#include <optional>

#include "claims/evaluate.hpp"

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
  MultiPolynomial operator-() const;
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

/// Fractions are equal or not; order is decided for none.
struct FractionField {
  std::shared_ptr<PolynomialRing> ring;
  Fraction constant(const Rational& value) const { return MultiPolynomial(ring, value); }
  bool is_zero(const Fraction& x) const { return x.numerator.is_zero(); }
  std::optional<int> compare(const Fraction& x, const Fraction& y) const {
    return (x - y).numerator.is_zero() ? std::optional(0) : std::nullopt;
  }
};

/// An evaluator whose parameters and force are variables.
Evaluator<Fraction, FractionField> symbolic(const Scope& scope, std::size_t first, std::size_t count);

}  // namespace slipproof
