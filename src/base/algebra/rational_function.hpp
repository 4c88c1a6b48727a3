// Quotients of polynomials in one variable: what a formula of one bicycle is in its force F.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/number/affine.hpp"
#include "base/number/rational.hpp"

namespace slipproof {

/// A polynomial in one variable: coefficients from the constant up, without leading zeros; empty is 0.
class Polynomial {
 public:
  Polynomial() = default;
  explicit Polynomial(std::vector<Rational> coefficients) : coefficients_(std::move(coefficients)) {
    while (!coefficients_.empty() && coefficients_.back().is_zero()) coefficients_.pop_back();
  }

  const std::vector<Rational>& coefficients() const { return coefficients_; }
  bool is_zero() const { return coefficients_.empty(); }
  /// The degree; 0 for constants and for the zero polynomial.
  std::size_t degree() const { return coefficients_.empty() ? 0 : coefficients_.size() - 1; }
  Rational coefficient(std::size_t power) const {
    return power < coefficients_.size() ? coefficients_[power] : Rational(0);
  }
  Rational at(const Rational& x) const {
    Rational value = 0;
    for (auto c = coefficients_.rbegin(); c != coefficients_.rend(); ++c) value = value * x + *c;
    return value;
  }
  bool operator==(const Polynomial&) const = default;

 private:
  std::vector<Rational> coefficients_;
};

inline Polynomial operator*(const Polynomial& p, const Polynomial& q) {
  if (p.is_zero() || q.is_zero()) return {};
  std::vector<Rational> product(p.degree() + q.degree() + 1);
  for (std::size_t i = 0; i <= p.degree(); ++i) {
    for (std::size_t j = 0; j <= q.degree(); ++j) product[i + j] += p.coefficients()[i] * q.coefficients()[j];
  }
  return Polynomial(std::move(product));
}

inline Polynomial operator+(const Polynomial& p, const Polynomial& q) {
  std::vector<Rational> total = p.coefficients();
  total.resize(std::max(total.size(), q.coefficients().size()));
  for (std::size_t i = 0; i < q.coefficients().size(); ++i) total[i] += q.coefficients()[i];
  return Polynomial(std::move(total));
}

inline Polynomial operator-(const Polynomial& p) {
  std::vector<Rational> negated = p.coefficients();
  for (Rational& c : negated) c = -c;
  return Polynomial(std::move(negated));
}

/// numerator / denominator, denominator not 0. Common factors are not sought beyond constants, so that the degrees grow
/// with the formula; equality is of values.
class RationalFunction {
 public:
  RationalFunction() : denominator_({Rational(1)}) {}
  RationalFunction(const Rational& constant) : RationalFunction(Polynomial({constant})) {}  // NOLINT: constants belong
  RationalFunction(const Affine<Rational>& affine)                                          // NOLINT: so do these
      : RationalFunction(Polynomial({affine.alpha, affine.beta})) {}
  explicit RationalFunction(Polynomial numerator) : RationalFunction(std::move(numerator), Polynomial({Rational(1)})) {}
  /// The denominator must not be 0.
  RationalFunction(Polynomial numerator, Polynomial denominator)
      : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
    if (denominator_.degree() == 0 && denominator_.coefficients()[0] != 1) {
      numerator_ = numerator_ * Polynomial({Rational(1 / denominator_.coefficients()[0])});
      denominator_ = Polynomial({Rational(1)});
    }
  }
  /// The variable itself.
  static RationalFunction variable() { return RationalFunction(Polynomial({Rational(0), Rational(1)})); }

  const Polynomial& numerator() const { return numerator_; }
  const Polynomial& denominator() const { return denominator_; }
  bool is_zero() const { return numerator_.is_zero(); }
  /// True if numerator and denominator as stored are constants; the value is then numerator().coefficient(0).
  bool is_constant() const { return numerator_.degree() == 0 && denominator_.degree() == 0; }

  /// The value of a constant. Most values that claims compare are constants; their denominator is 1.
  Rational value() const { return numerator_.coefficient(0); }

  friend RationalFunction operator+(const RationalFunction& x, const RationalFunction& y) {
    if (x.is_constant() && y.is_constant()) return x.value() + y.value();
    if (x.denominator_ == y.denominator_) return {x.numerator_ + y.numerator_, x.denominator_};
    return {x.numerator_ * y.denominator_ + y.numerator_ * x.denominator_, x.denominator_ * y.denominator_};
  }
  friend RationalFunction operator-(const RationalFunction& x) { return {-x.numerator_, x.denominator_}; }
  friend RationalFunction operator-(const RationalFunction& x, const RationalFunction& y) { return x + -y; }
  friend RationalFunction operator*(const RationalFunction& x, const RationalFunction& y) {
    if (x.is_constant() && y.is_constant()) return x.value() * y.value();
    return {x.numerator_ * y.numerator_, x.denominator_ * y.denominator_};
  }
  /// y must not be zero.
  friend RationalFunction operator/(const RationalFunction& x, const RationalFunction& y) {
    if (x.is_constant() && y.is_constant()) return x.value() / y.value();
    return {x.numerator_ * y.denominator_, x.denominator_ * y.numerator_};
  }
  friend bool operator==(const RationalFunction& x, const RationalFunction& y) { return (x - y).is_zero(); }

 private:
  Polynomial numerator_;
  Polynomial denominator_;
};

}  // namespace slipproof
