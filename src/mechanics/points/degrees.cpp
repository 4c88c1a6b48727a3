#include "mechanics/points/degrees.hpp"

#include <mpfr.h>

#include <cmath>
#include <optional>

#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "base/number/parse.hpp"

namespace slipproof {

namespace {

constexpr mpfr_prec_t precision = 320;  // binary64 and its rounding error, with room to spare

class Real {
 public:
  Real() { mpfr_init2(value, precision); }
  ~Real() { mpfr_clear(value); }
  Real(const Real&) = delete;
  Real& operator=(const Real&) = delete;
  mpfr_t value;
};

/// degrees * pi / 360
void half_in_radians(const Rational& degrees, Real& result) {
  Real pi;
  mpfr_set_q(result.value, GmpRational(degrees).get(), MPFR_RNDN);
  mpfr_const_pi(pi.value, MPFR_RNDN);
  mpfr_mul(result.value, result.value, pi.value, MPFR_RNDN);
  mpfr_div_ui(result.value, result.value, 360, MPFR_RNDN);
}

Rational to_three_digits(const Rational& x) {
  return parse_rational(decimal_text(x, 3));
}

/// 360 / pi * arctan(tan_half) - degrees
Rational difference_of_angle(const Rational& tan_half, const Rational& degrees) {
  Real angle, pi, asked;
  mpfr_set_q(angle.value, GmpRational(tan_half).get(), MPFR_RNDN);
  mpfr_atan(angle.value, angle.value, MPFR_RNDN);
  mpfr_const_pi(pi.value, MPFR_RNDN);
  mpfr_mul_ui(angle.value, angle.value, 360, MPFR_RNDN);
  mpfr_div(angle.value, angle.value, pi.value, MPFR_RNDN);
  mpfr_set_q(asked.value, GmpRational(degrees).get(), MPFR_RNDN);
  mpfr_sub(angle.value, angle.value, asked.value, MPFR_RNDN);
  return to_three_digits(to_rational(mpfr_get_d(angle.value, MPFR_RNDN)));
}

/// The angle in (-180, 180].
Rational within_a_turn(const Rational& degrees) {
  const Rational turns = (Rational(180) - degrees) / 360;
  Integer floor = numerator(turns) / denominator(turns);
  if (Rational(floor) > turns) floor -= 1;
  return degrees + Rational(360) * Rational(floor);
}

std::optional<MechanismValues::Circle> quarter_turn(const Rational& degrees) {
  if (degrees.is_zero()) return MechanismValues::Circle{1, 0};
  if (degrees == 90) return MechanismValues::Circle{0, 1};
  if (degrees == 180) return MechanismValues::Circle{-1, 0};
  if (degrees == -90) return MechanismValues::Circle{0, -1};
  return std::nullopt;
}

Rational power_of_ten(unsigned exponent) {
  Rational result = 1;
  for (unsigned i = 0; i < exponent; ++i) result *= 10;
  return result;
}

/// 180/pi * arctan(tangent) for a tangent above 0, rounded to one side. pi rounds to the other, as it divides.
Rational rounded_degrees(const Rational& tangent, const Rational& scale, mpfr_rnd_t side) {
  Real angle, pi;
  mpfr_set_q(angle.value, GmpRational(tangent).get(), side);
  mpfr_atan(angle.value, angle.value, side);
  mpfr_const_pi(pi.value, side == MPFR_RNDD ? MPFR_RNDU : MPFR_RNDD);
  mpfr_mul_ui(angle.value, angle.value, 180, side);
  mpfr_div(angle.value, angle.value, pi.value, side);
  mpfr_mul_q(angle.value, angle.value, GmpRational(scale).get(), side);
  mpz_t whole;
  mpz_init(whole);
  mpfr_get_z(whole, angle.value, side);
  const Rational result = Rational(Integer(whole)) / scale;
  mpz_clear(whole);
  return result;
}

}  // namespace

std::pair<Rational, Rational> degrees_of_direction(const Rational& x, const Rational& y, unsigned decimals) {
  const Rational across = abs(x), up = abs(y);
  Rational low, high;  // in the first quarter
  if (up.is_zero() || across.is_zero() || up == across) {
    low = high = up.is_zero() ? 0 : across.is_zero() ? 90 : 45;
  } else {
    const Rational scale = power_of_ten(decimals), tangent = up / across;
    low = rounded_degrees(tangent, scale, MPFR_RNDD);
    high = rounded_degrees(tangent, scale, MPFR_RNDU);
  }
  if (x.sign() < 0) {
    const Rational kept = low;
    low = Rational(180) - high, high = Rational(180) - kept;
  }
  if (y.sign() >= 0) return {low, high};
  return {-high, -low};
}

MechanismValues::Circle point_of_tan_half(const Rational& tan_half) {
  const Rational square = tan_half * tan_half;
  const Rational scale = Rational(1) / (Rational(1) + square);
  return {(Rational(1) - square) * scale, Rational(2) * tan_half * scale};
}

AngleFromDegrees angle_from_degrees(const Rational& degrees) {
  const Rational angle = within_a_turn(degrees);
  if (const auto exact = quarter_turn(angle)) return {*exact, 0};
  const Rational size = abs(angle);
  const bool steep = size > 90;  // the tangent of what is left to 180 degrees is as exact as it is
  Real tangent;
  half_in_radians(steep ? Rational(Rational(180) - size) : size, tangent);
  mpfr_tan(tangent.value, tangent.value, MPFR_RNDN);
  if (steep) mpfr_ui_div(tangent.value, 1, tangent.value, MPFR_RNDN);
  const double half = mpfr_get_d(tangent.value, MPFR_RNDN);
  const int side = sign(angle);
  if (!std::isfinite(half)) return {{-1, 0}, to_three_digits(Rational(side) * (Rational(180) - size))};
  const Rational tan_half = to_rational(side < 0 ? -half : half);
  return {point_of_tan_half(tan_half), difference_of_angle(tan_half, angle)};
}

}  // namespace slipproof
