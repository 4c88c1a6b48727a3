// A formula along a line of points: a quotient of polynomials in the force variable F whose coefficients are
// polynomials in the line's t.
#pragma once

#include <vector>

#include "base/algebra/integer_polynomial.hpp"
#include "base/number/affine.hpp"

namespace slipproof {

/// Coefficients of powers of F, from the constant up, without leading zeros.
using ForcePolynomial = std::vector<IntegerPolynomial>;

/// numerator / denominator; the denominator is not 0. Factors that do not depend on F are cancelled: users know all
/// divisors and avoid their zeros. Other factors are treated as in RationalFunction, and at every t this is one.
class LineFunction {
 public:
  LineFunction() : denominator_{IntegerPolynomial(1)} {}
  explicit LineFunction(const Rational& constant);
  explicit LineFunction(IntegerPolynomial polynomial);
  explicit LineFunction(const Affine<IntegerPolynomial>& numerator, IntegerPolynomial denominator);
  /// numerator / denominator in lowest terms.
  LineFunction(ForcePolynomial numerator, ForcePolynomial denominator);
  /// constant + slope t.
  static LineFunction linear(const Rational& constant, const Rational& slope);
  static LineFunction force() {
    return {ForcePolynomial{IntegerPolynomial(0), IntegerPolynomial(1)}, ForcePolynomial{IntegerPolynomial(1)}};
  }

  const ForcePolynomial& numerator() const { return numerator_; }
  const ForcePolynomial& denominator() const { return denominator_; }
  bool is_zero() const { return numerator_.empty(); }
  bool without_force() const { return numerator_.size() <= 1 && denominator_.size() == 1; }

  friend LineFunction operator+(const LineFunction& x, const LineFunction& y);
  friend LineFunction operator-(const LineFunction& x);
  friend LineFunction operator-(const LineFunction& x, const LineFunction& y) { return x + -y; }
  friend LineFunction operator*(const LineFunction& x, const LineFunction& y);
  friend LineFunction operator/(const LineFunction& x, const LineFunction& y);  ///< y must not be zero

 private:
  void cancel();

  ForcePolynomial numerator_, denominator_;
};

/// Optimised for denominators that are 1, as most are.
IntegerPolynomial least_common_multiple(const IntegerPolynomial& x, const IntegerPolynomial& y);
/// x multiple / divisor, where the divisor divides the multiple.
IntegerPolynomial scaled(const IntegerPolynomial& x, const IntegerPolynomial& multiple,
                         const IntegerPolynomial& divisor);

}  // namespace slipproof
