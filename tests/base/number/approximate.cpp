#include "base/rounding/approximate.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

#include "base/number/binary64.hpp"

using namespace slipproof;

namespace {

struct Both {
  Approximate nearby;
  Rational exact;
};

class NumbersOfAnySize {
 public:
  long number(long low, long high) {
    return low + static_cast<long>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  /// Short and long fractions, integers next to 2^53 and 2^63, and sizes at which products underflow and overflow.
  Rational rational() {
    const long kind = number(0, 5), sign = number(0, 1) == 0 ? -1 : 1;
    const long divisor = number(1, 40);
    if (kind == 0) return Rational(sign * number(0, 20));
    if (kind == 1) return Rational(sign * number(0, 60), divisor);
    if (kind == 2) return Rational(sign * ((1L << 53) + number(-2, 2)), divisor);
    if (kind == 3) return Rational(Integer(sign) * ((Integer(1) << 63) + number(-2, 2)), (Integer(1) << 70) + divisor);
    if (kind == 4) return Rational(sign * number(1, 60), divisor) * power_of_two(number(-60, 60));
    return Rational(sign * number(1, 60), divisor) * power_of_two(number(-1100, 1100));
  }

 private:
  std::mt19937_64 engine_{53};
};

/// Whether the bound holds; an unknown one holds nothing.
bool is_bounded(const Both& x) {
  if (!std::isfinite(x.nearby.value) || !std::isfinite(x.nearby.error)) return true;
  return abs(to_rational(x.nearby.value) - x.exact) <= to_rational(x.nearby.error);
}

Both combined(long operation, const Both& x, const Both& y) {
  if (operation == 0) return {x.nearby + y.nearby, x.exact + y.exact};
  if (operation == 1) return {x.nearby - y.nearby, x.exact - y.exact};
  if (operation == 2 || y.exact.is_zero()) return {x.nearby * y.nearby, x.exact * y.exact};
  return {x.nearby / y.nearby, x.exact / y.exact};
}

}  // namespace

TEST_CASE("a bound on the error of binary64 holds for random formulas, and what is sure of signs is so") {
  NumbersOfAnySize draw;
  int sure = 0, open = 0;
  for (int formula = 0; formula < 4000; ++formula) {
    std::vector<Both> known;
    for (int i = 0; i < 4; ++i) {
      const Rational x = draw.rational();
      known.push_back({Approximate(x), x});
      CHECK(is_bounded(known.back()));
    }
    for (int step = 0; step < 10; ++step) {
      const auto any = [&] { return known[static_cast<std::size_t>(draw.number(0, std::ssize(known) - 1))]; };
      const long operation = draw.number(0, 3);
      const Both x = any(), y = any();
      known.push_back(combined(operation, x, y));
      CHECK(is_bounded(known.back()));
      const auto sign = sure_sign(known.back().nearby);
      if (sign) CHECK(*sign == known.back().exact.sign());
      (sign ? sure : open) += 1;
    }
  }
  CHECK(sure > 4 * open);
}

TEST_CASE("a sum that is 0 but for roundings has no sure sign") {
  NumbersOfAnySize draw;
  int rounded = 0;
  for (int i = 0; i < 2000; ++i) {
    const Rational x(draw.number(1, 60), draw.number(1, 40)), y(draw.number(1, 60), draw.number(1, 40));
    const Approximate a(x), b(y);
    const Approximate zero = (a + b) * (a - b) - (a * a - b * b);
    rounded += zero.value != 0 ? 1 : 0;
    const auto sign = sure_sign(zero);
    CHECK((!sign || *sign == 0));
  }
  CHECK(rounded > 500);
}

TEST_CASE("overflow, NaN and divisors that may be 0 leave all signs open, an exact 0 none") {
  const Approximate huge(power_of_two(1000)), third(Rational(1, 3)), maybe = third + third + third - 1;
  CHECK_FALSE(sure_sign(huge * huge));
  CHECK_FALSE(sure_sign(huge * huge - huge * huge));
  CHECK_FALSE(sure_sign(maybe));
  CHECK_FALSE(sure_sign(third / maybe));
  CHECK_FALSE(sure_sign(third / (third - third)));
  CHECK_FALSE(sure_sign(Approximate(std::nan(""))));
  CHECK(sure_sign(Approximate(power_of_two(2000))) == std::nullopt);
  CHECK(sure_sign(Approximate(power_of_two(-2000))) == std::nullopt);
  CHECK(sure_sign(Approximate(0.0) * huge) == 0);
  CHECK(sure_sign(Approximate(Rational(1, 4)) + Approximate(Rational(-1, 4))) == 0);
}
