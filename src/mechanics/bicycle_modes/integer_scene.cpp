#include "mechanics/bicycle_modes/integer_scene.hpp"

#include <functional>
#include <initializer_list>

#include "base/algebra/bareiss.hpp"

namespace slipproof {

namespace {

using Values = std::initializer_list<std::reference_wrapper<const Rational>>;

}  // namespace

IntegerScene to_integers(const Bicycle<Rational>& p, const Road<Rational>& road) {
  IntegerScene s;
  s.length = common_denominator(Values{p.R, p.h, p.b2, p.b3, p.L});
  const Integer area = s.length * s.length;
  const Rational square(area);
  const Rational I1 = p.I1 * square, I2 = p.I2 * square, I3 = p.I3 * square;
  const Rational J = p.J ? Rational(*p.J * square) : Rational(0);
  s.mass = common_denominator(Values{p.M, I1, I2, I3, J});
  const Rational g = road.g * Rational(s.length);
  s.rate = denominator(g);
  const Integer radius = common_denominator(Values{p.r1, p.r2});

  s.bicycle = {.M = integer_times(p.M, s.mass),
               .R = integer_times(p.R, s.length),
               .h = integer_times(p.h, s.length),
               .b2 = integer_times(p.b2, s.length),
               .b3 = integer_times(p.b3, s.length),
               .I1 = integer_times(I1, s.mass),
               .I2 = integer_times(I2, s.mass),
               .I3 = integer_times(I3, s.mass),
               .r1 = integer_times(p.r1, radius),
               .r2 = integer_times(p.r2, radius),
               .L = integer_times(p.L, s.length),
               .J = p.J ? std::optional<Integer>(integer_times(J, s.mass)) : std::nullopt};
  s.road = {.f = numerator(road.f), .g = numerator(g)};
  s.friction_denominator = denominator(road.f);
  s.acceleration = s.length * s.rate;
  s.force = s.mass * s.acceleration;
  return s;
}

const Integer& IntegerScene::unit(Quantity quantity) const {
  switch (quantity) {
    case Quantity::phi:
    case Quantity::eps2:
    case Quantity::eps3:
      return rate;
    case Quantity::S2:
    case Quantity::S3:
    case Quantity::N2:
    case Quantity::N3:
      return force;
    default:
      return acceleration;
  }
}

}  // namespace slipproof
