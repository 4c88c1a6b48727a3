// The constants of filter/bounds.hpp, counted anew; and the bounds that they give, against exact values.
#include "floating/filter/bounds.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "error_count.hpp"
#include "floating/filter/filter.hpp"
#include "mechanics/bicycle/conditions.hpp"
#include "support/filter_scenes.hpp"

using namespace slipproof;
using slipproof::test::ErrorCount;

namespace {

/// Calls `see` with every expression whose value the filter uses.
template <class N, class See>
void each_expression(const ReducedDynamics<N, N>& d, ContactMode mode, const See& see) {
  const ReducedMotion<N, N> motion(d, mode);
  see(motion.determinant());
  for (const Condition& c : conditions(mode)) see(motion.condition_value(c).numerator);
  for (const Quantity q : all_quantities()) {
    see(motion.quantity(q).numerator);
    see(motion.quantity(q).denominator);
  }
}

}  // namespace

TEST_CASE("the named constants are what the counting number type finds in the reduction") {
  const Integer limit = numerator(to_rational(input_limit));
  const auto in = [&] { return ErrorCount::input(limit); };
  long roundings = 0, underflow = 0, magnitude = 0;
  for (const ForceKind kind : {ForceKind::internal, ForceKind::external}) {
    const Bicycle<ErrorCount> p{in(), in(), in(), in(), in(), in(), in(), in(), in(), in(), in(), in()};
    const auto d = reduce<ErrorCount, ErrorCount>(p, {in(), in()}, kind, in(), ErrorCount(1));
    for (const ContactMode mode : all_modes()) {
      each_expression(d, mode, [&](const ErrorCount& x) {
        roundings = std::max(roundings, x.roundings);
        underflow = std::max(underflow, test::bits(x.underflow));
        magnitude = std::max(magnitude, test::bits(x.magnitude));
      });
    }
  }
  CHECK(roundings == counted_roundings);
  CHECK(underflow == counted_underflow_bits);
  CHECK(magnitude < 1000);  // no overflow, neither in the magnitude nor in Veltkamp's splitting
  CHECK(std::ldexp(4.0, counted_underflow_bits - 1075) == underflow_error);
}

TEST_CASE("the bounds as they are computed cover the counted roundings, second-order terms and their own roundings") {
  const Rational u = to_rational(std::numeric_limits<double>::epsilon()) / 2, one = 1;
  CHECK(to_rational(unit_roundoff) == u);
  const auto power = [](Rational x, int n) {
    Rational product = 1;
    for (; n > 0; --n) product *= x;
    return product;
  };
  // The magnitude comes out too small by up to (1 - u)^d, the two operations of the bound by (1 - u)^2.
  const Rational low = power(one - u, counted_roundings + 2);
  CHECK(power(one + u, counted_roundings) - 1 <= error_roundings * u * low);
  CHECK(counted_roundings * u / (one - counted_roundings * u) <= error_roundings * u * low);
  // Each operation on double-double numbers errs by up to 7 u^2.
  const Rational errors = power(one + 7 * u * u, counted_roundings) - 1;
  CHECK(errors <= error_roundings * to_rational(double_double_roundoff) * low);
}

TEST_CASE("no expression is further from its exact value than its bound, and the bound is no idle one") {
  test::FilterScenes random(51);
  double worst = 0, worst2 = 0;
  for (int i = 0; i < 400; ++i) {
    auto s = random.scene(i % 2 == 0 ? test::Population::wide : test::Population::fractions);
    s.F = to_rational(random.signed_log(1e-2, 1e3));
    if (i % 4 == 1) s.F = Rational(1, 1 + i);
    const auto exact = reduce<Rational, Rational>(s.bicycle, s.road, s.force_kind, s.F, Rational(1));
    const auto tracked = tracked_dynamics<Tracked>(nearest_binary64(s));
    const auto tracked2 = tracked_dynamics<TrackedDouble2>(s);
    for (const ContactMode mode : all_modes()) {
      if (!mode.on_road() && !s.bicycle.J) continue;
      std::vector<Rational> values;
      each_expression(exact, mode, [&](const Rational& x) { values.push_back(x); });
      std::size_t k = 0;
      each_expression(tracked, mode, [&](const Tracked& x) {
        const Rational error = abs(values[k++] - to_rational(x.value())), bound = to_rational(x.error());
        CHECK(error <= bound);
        worst = std::max(worst, nearest_binary64(error / bound));
      });
      k = 0;
      each_expression(tracked2, mode, [&](const TrackedDouble2& x) {
        // value() is the upper half only
        const Rational error = abs(values[k++] - to_rational(x.value()) - to_rational(x.low()));
        const Rational bound = to_rational(x.error());
        CHECK(error <= bound);
        worst2 = std::max(worst2, nearest_binary64(error / bound));
      });
    }
  }
  MESSAGE("largest error / bound: binary64 " << worst << ", double-double " << worst2);
  CHECK(worst > 0.01);
  CHECK(worst2 > 0.001);
}
