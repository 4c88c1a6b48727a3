// Polynomials in one variable with integer coefficients, over FLINT: what a formula is along a line of bicycles.
#pragma once

#include <flint/fmpz_poly.h>

#include <vector>

#include "base/number/rational.hpp"

namespace slipproof {

/// A commutative ring with exact division only. Any degree; the zero polynomial has degree -1.
class IntegerPolynomial {
 public:
  IntegerPolynomial(int constant = 0) {  // NOLINT: integers belong
    fmpz_poly_init(value_);
    fmpz_poly_set_si(value_, constant);
  }
  explicit IntegerPolynomial(const Integer& constant) {
    fmpz_poly_init(value_);
    set_coefficient(0, constant);
  }
  /// constant + slope t.
  IntegerPolynomial(const Integer& constant, const Integer& slope) : IntegerPolynomial(constant) {
    set_coefficient(1, slope);
  }
  IntegerPolynomial(const IntegerPolynomial& other) {
    fmpz_poly_init(value_);
    fmpz_poly_set(value_, other.value_);
  }
  IntegerPolynomial(IntegerPolynomial&& other) noexcept {
    fmpz_poly_init(value_);
    fmpz_poly_swap(value_, other.value_);
  }
  IntegerPolynomial& operator=(IntegerPolynomial other) noexcept {
    fmpz_poly_swap(value_, other.value_);
    return *this;
  }
  ~IntegerPolynomial() { fmpz_poly_clear(value_); }

  /// Makes a polynomial of rational coefficients, constant first, multiplied by their common denominator.
  static IntegerPolynomial proportional_to(const std::vector<Rational>& coefficients) {
    Integer common = 1;
    for (const Rational& c : coefficients) common = lcm(common, denominator(c));
    IntegerPolynomial result;
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
      result.set_coefficient(static_cast<long>(i), numerator(coefficients[i] * common));
    }
    return result;
  }

  long degree() const { return fmpz_poly_degree(value_); }
  bool is_zero() const { return fmpz_poly_is_zero(value_) != 0; }
  bool is_one() const { return fmpz_poly_is_one(value_) != 0; }
  Integer coefficient(long power) const;
  /// The sign of the value at a number; Horner's scheme in integers.
  int sign_at(const Rational& t) const;
  /// The number of sign changes in the sequence of nonzero coefficients, an upper bound on the number of positive roots
  /// (Descartes).
  int sign_changes() const;
  /// The polynomial with coprime coefficients, the leading one positive, that has the same roots; 0 stays 0.
  IntegerPolynomial primitive() const;
  /// The same bound for the roots in (0, 1).
  int sign_changes_in_unit() const;
  /// A polynomial whose positive roots are the roots beyond `lower`, moved.
  IntegerPolynomial beyond(const Rational& lower) const;
  /// A polynomial whose roots in (0, 1) are the roots between two numbers, moved and scaled.
  IntegerPolynomial on_unit(const Rational& lower, const Rational& upper) const;
  /// p(t/2), times a positive number.
  IntegerPolynomial stretched_twice() const;
  /// p(-t).
  IntegerPolynomial mirrored() const;

  friend IntegerPolynomial operator+(IntegerPolynomial x, const IntegerPolynomial& y) {
    fmpz_poly_add(x.value_, x.value_, y.value_);
    return x;
  }
  friend IntegerPolynomial operator-(IntegerPolynomial x, const IntegerPolynomial& y) {
    fmpz_poly_sub(x.value_, x.value_, y.value_);
    return x;
  }
  friend IntegerPolynomial operator-(IntegerPolynomial x) {
    fmpz_poly_neg(x.value_, x.value_);
    return x;
  }
  friend IntegerPolynomial operator*(const IntegerPolynomial& x, const IntegerPolynomial& y) {
    IntegerPolynomial result;
    fmpz_poly_mul(result.value_, x.value_, y.value_);
    return result;
  }
  friend bool operator==(const IntegerPolynomial& x, const IntegerPolynomial& y) {
    return fmpz_poly_equal(x.value_, y.value_) != 0;
  }
  /// A total order, for use as a key.
  friend bool operator<(const IntegerPolynomial& x, const IntegerPolynomial& y);
  /// The greatest common divisor, its leading coefficient positive.
  friend IntegerPolynomial gcd(const IntegerPolynomial& x, const IntegerPolynomial& y) {
    IntegerPolynomial result;
    fmpz_poly_gcd(result.value_, x.value_, y.value_);
    return result;
  }
  /// x / y, which must be a polynomial with integer coefficients.
  friend IntegerPolynomial exact_quotient(const IntegerPolynomial& x, const IntegerPolynomial& y) {
    IntegerPolynomial result;
    fmpz_poly_div(result.value_, x.value_, y.value_);
    return result;
  }

  /// FLINT's representation, for calls of its functions.
  const fmpz_poly_struct* flint() const { return value_; }
  fmpz_poly_struct* flint() { return value_; }

 private:
  void set_coefficient(long power, const Integer& x);

  fmpz_poly_t value_;
};

/// The determinant of a square matrix; ignores further columns.
IntegerPolynomial determinant(const std::vector<std::vector<IntegerPolynomial>>& rows);

}  // namespace slipproof
