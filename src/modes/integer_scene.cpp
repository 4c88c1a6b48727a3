#include "modes/integer_scene.hpp"

#include <initializer_list>

namespace slipproof {

namespace {

Integer common_denominator(std::initializer_list<const Rational*> values) {
  Integer result = 1;
  for (const Rational* value : values) {
    const Integer d = denominator(*value);
    if (d != 1) result = lcm(result, d);
  }
  return result;
}

/// value * unit, an integer by the choice of the unit.
Integer in_units(const Rational& value, const Integer& unit) {
  return numerator(value) * Integer(unit / denominator(value));
}

}  // namespace

IntegerScene to_integers(const Bicycle<Rational>& p, const Road<Rational>& road) {
  IntegerScene s;
  s.length = common_denominator({&p.R, &p.h, &p.b2, &p.b3, &p.L});
  const Integer area = s.length * s.length;
  const Rational square(area);
  const Rational I1 = p.I1 * square, I2 = p.I2 * square, I3 = p.I3 * square;
  const Rational J = p.J ? Rational(*p.J * square) : Rational(0);
  s.mass = common_denominator({&p.M, &I1, &I2, &I3, &J});
  const Rational g = road.g * Rational(s.length);
  s.rate = denominator(g);
  const Integer radius = common_denominator({&p.r1, &p.r2});

  s.bicycle = {.M = in_units(p.M, s.mass),
               .R = in_units(p.R, s.length),
               .h = in_units(p.h, s.length),
               .b2 = in_units(p.b2, s.length),
               .b3 = in_units(p.b3, s.length),
               .I1 = in_units(I1, s.mass),
               .I2 = in_units(I2, s.mass),
               .I3 = in_units(I3, s.mass),
               .r1 = in_units(p.r1, radius),
               .r2 = in_units(p.r2, radius),
               .L = in_units(p.L, s.length),
               .J = p.J ? std::optional<Integer>(in_units(J, s.mass)) : std::nullopt};
  s.road = {.f = numerator(road.f), .g = numerator(g)};
  s.friction_denominator = denominator(road.f);
  return s;
}

Integer IntegerScene::unit(Quantity quantity) const {
  switch (quantity) {
    case Quantity::phi:
    case Quantity::eps2:
    case Quantity::eps3:
      return rate;
    case Quantity::S2:
    case Quantity::S3:
    case Quantity::N2:
    case Quantity::N3:
      return force_unit();
    default:
      return length * rate;
  }
}

}  // namespace slipproof
