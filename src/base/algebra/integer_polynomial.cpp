#include "base/algebra/integer_polynomial.hpp"

#include <flint/fmpz_poly_mat.h>

#include "base/rounding/approximate.hpp"

namespace slipproof {

namespace {

/// Coefficient k times factor^k, or factor^(degree - k).
void scale(fmpz_poly_struct* p, const Integer& factor, bool downwards) {
  if (factor == 1) return;
  Integer power = 1;
  const slong length = fmpz_poly_length(p);
  for (slong i = 0; i < length; ++i) {
    fmpz* coefficient = fmpz_poly_get_coeff_ptr(p, downwards ? length - 1 - i : i);
    fmpz_mul(coefficient, coefficient, power.flint());
    power *= factor;
  }
}

/// p(t + shift), times a positive number.
void move(fmpz_poly_struct* p, const Rational& shift) {
  if (shift.is_zero()) return;
  // d^n p((s + n)/d) at s = d t: scaled, shifted by an integer, and scaled back.
  scale(p, denominator(shift), true);
  fmpz_poly_taylor_shift(p, p, numerator(shift).flint());
  scale(p, denominator(shift), false);
}

}  // namespace

void IntegerPolynomial::set_coefficient(long power, const Integer& x) {
  fmpz_poly_set_coeff_fmpz(value_, power, x.flint());
}

Integer IntegerPolynomial::coefficient(long power) const {
  Integer result;
  fmpz_poly_get_coeff_fmpz(result.flint(), value_, power);
  return result;
}

int IntegerPolynomial::sign_at(const Rational& t) const {
  const Approximate near(t);
  Approximate sum;
  for (long i = degree(); i >= 0; --i) sum = sum * near + Approximate(coefficient(i));
  if (const auto sure = sure_sign(sum)) return *sure;
  const Integer &n = numerator(t), &d = denominator(t);
  Integer value, power = 1;
  // d^degree p(n/d), from the leading coefficient down.
  for (slong i = degree(); i >= 0; --i) {
    value *= n;
    fmpz_addmul(value.flint(), fmpz_poly_get_coeff_ptr(value_, i), power.flint());
    power *= d;
  }
  return value.sign();
}

int IntegerPolynomial::sign_changes() const {
  int changes = 0, last = 0;
  for (slong i = 0; i <= degree(); ++i) {
    const int here = fmpz_sgn(fmpz_poly_get_coeff_ptr(value_, i));
    if (here == 0) continue;
    if (last == -here) ++changes;
    last = here;
  }
  return changes;
}

int IntegerPolynomial::sign_changes_in_unit() const {
  // t = 1/(1 + s) goes to s in (0, oo): coefficients turned round, moved by 1.
  IntegerPolynomial turned;
  fmpz_poly_reverse(turned.value_, value_, degree() + 1);
  fmpz_poly_taylor_shift(turned.value_, turned.value_, Integer(1).flint());
  return turned.sign_changes();
}

IntegerPolynomial IntegerPolynomial::primitive() const {
  IntegerPolynomial result;
  fmpz_poly_primitive_part(result.value_, value_);
  return result;
}

IntegerPolynomial IntegerPolynomial::beyond(const Rational& lower) const {
  IntegerPolynomial result = *this;
  move(result.value_, lower);
  return result;
}

IntegerPolynomial IntegerPolynomial::on_unit(const Rational& lower, const Rational& upper) const {
  IntegerPolynomial result = beyond(lower);
  const Rational width = upper - lower;
  scale(result.value_, numerator(width), false);
  scale(result.value_, denominator(width), true);
  return result;
}

IntegerPolynomial IntegerPolynomial::stretched_twice() const {
  IntegerPolynomial result = *this;
  for (slong i = 0; i < degree(); ++i) {
    fmpz* coefficient = fmpz_poly_get_coeff_ptr(result.value_, i);
    fmpz_mul_2exp(coefficient, coefficient, static_cast<ulong>(degree() - i));
  }
  return result;
}

IntegerPolynomial IntegerPolynomial::mirrored() const {
  IntegerPolynomial result = *this;
  for (slong i = 1; i <= degree(); i += 2) {
    fmpz* coefficient = fmpz_poly_get_coeff_ptr(result.value_, i);
    fmpz_neg(coefficient, coefficient);
  }
  return result;
}

bool operator<(const IntegerPolynomial& x, const IntegerPolynomial& y) {
  if (x.degree() != y.degree()) return x.degree() < y.degree();
  for (slong i = x.degree(); i >= 0; --i) {
    const int order = fmpz_cmp(fmpz_poly_get_coeff_ptr(x.value_, i), fmpz_poly_get_coeff_ptr(y.value_, i));
    if (order != 0) return order < 0;
  }
  return false;
}

IntegerPolynomial determinant(const std::vector<std::vector<IntegerPolynomial>>& rows) {
  const auto size = static_cast<slong>(rows.size());
  fmpz_poly_mat_t matrix;
  fmpz_poly_mat_init(matrix, size, size);
  for (slong i = 0; i < size; ++i) {
    const auto& row = rows[static_cast<std::size_t>(i)];
    for (slong j = 0; j < size; ++j)
      fmpz_poly_set(fmpz_poly_mat_entry(matrix, i, j), row[static_cast<std::size_t>(j)].flint());
  }
  IntegerPolynomial result;
  fmpz_poly_mat_det(result.flint(), matrix);
  fmpz_poly_mat_clear(matrix);
  return result;
}

}  // namespace slipproof
