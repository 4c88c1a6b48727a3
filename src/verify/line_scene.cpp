#include "verify/line_scene.hpp"

#include <functional>
#include <initializer_list>

namespace slipproof {

namespace {

using Values = std::initializer_list<std::reference_wrapper<const LineFunction>>;

IntegerPolynomial common_multiple(const IntegerPolynomial& x, const IntegerPolynomial& y) {
  return exact_quotient(x * y, gcd(x, y));
}

IntegerPolynomial common_denominator(const Values& values) {
  IntegerPolynomial result(1);
  for (const LineFunction& value : values) result = common_multiple(result, value.denominator().front());
  return result;
}

/// The coefficient of a power of the force, times a multiple of the denominator.
IntegerPolynomial times(const LineFunction& value, const IntegerPolynomial& multiple, std::size_t power = 0) {
  if (power >= value.numerator().size()) return 0;
  return exact_quotient(value.numerator()[power] * multiple, value.denominator().front());
}

}  // namespace

IntegerPolynomial LineScene::unit(Quantity quantity) const {
  switch (quantity) {
    case Quantity::phi:
    case Quantity::eps2:
    case Quantity::eps3:
      return rate;
    case Quantity::S2:
    case Quantity::S3:
    case Quantity::N2:
    case Quantity::N3:
      return mass * length * rate;
    default:
      return length * rate;
  }
}

std::optional<LineScene> line_scene(const std::vector<std::optional<LineFunction>>& values) {
  const LineFunction &M = *values[0], &R = *values[1], &h = *values[2], &b2 = *values[3], &b3 = *values[4],
                     &r1 = *values[8], &r2 = *values[9], &L = *values[10], &f = *values[12], &F = *values[14];
  if (F.numerator().size() != 2 || F.denominator().size() != 1) return std::nullopt;
  LineScene s;
  s.length = common_denominator({R, h, b2, b3, L});
  const LineFunction length(s.length), area(s.length * s.length);
  const LineFunction I1 = *values[5] * area, I2 = *values[6] * area, I3 = *values[7] * area;
  const LineFunction J = values[11] ? *values[11] * area : LineFunction();
  s.mass = common_denominator({M, I1, I2, I3, J});
  const LineFunction g = *values[13] * length;
  const LineFunction force = F * LineFunction(s.mass * s.length);
  s.rate = common_denominator({g, force});
  const IntegerPolynomial radius = common_denominator({r1, r2});
  s.bicycle = {.M = times(M, s.mass),
               .R = times(R, s.length),
               .h = times(h, s.length),
               .b2 = times(b2, s.length),
               .b3 = times(b3, s.length),
               .I1 = times(I1, s.mass),
               .I2 = times(I2, s.mass),
               .I3 = times(I3, s.mass),
               .r1 = times(r1, radius),
               .r2 = times(r2, radius),
               .L = times(L, s.length),
               .J = values[11] ? std::optional(times(J, s.mass)) : std::nullopt};
  s.road = {.f = times(f, f.denominator().front()), .g = times(g, s.rate)};
  s.friction_denominator = f.denominator().front();
  s.force = {times(force, s.rate, 0), times(force, s.rate, 1)};
  return s;
}

}  // namespace slipproof
