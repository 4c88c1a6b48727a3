#include "base/number/fixed_integer.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace slipproof;

namespace {

/// Integers under 2^`most`, of all lengths, many of them next to a power of two.
class Lengths {
 public:
  explicit Lengths(std::size_t most) : most_(most) {}

  Integer number() {
    const std::size_t length = engine_() % (most_ + 1);
    const Integer end = Integer(1) << length;
    Integer x = 0;
    for (std::size_t i = 0; i < length; i += 60) x = (x << 60) + Integer(static_cast<long>(engine_() >> 4U));
    x %= end;
    if (engine_() % 3 == 0) x = end - Integer(1);
    if (engine_() % 5 == 0) x = length == 0 ? Integer(0) : end >> 1;
    return engine_() % 2 == 0 ? x : -x;
  }

 private:
  std::mt19937_64 engine_{5};
  std::size_t most_;
};

/// How many of many results fit, and are right.
template <std::size_t limbs>
int fitting_results() {
  using Fixed = FixedInteger<limbs>;
  Lengths draw(Fixed::value_bits);
  int fitting = 0;
  const auto check = [&](const Integer& expected, const Fixed& found) {
    if (expected.bits() > Fixed::value_bits) return;
    ++fitting;
    CHECK(Integer(found) == expected);
    CHECK(found.sign() == expected.sign());
    CHECK(found.is_zero() == expected.is_zero());
    CHECK((found == Fixed(expected)));
  };
  for (int i = 0; i < 3000; ++i) {
    const Integer x = draw.number(), y = draw.number(), z = draw.number();
    const Fixed u(x), v(y), w(z);
    check(x, u);
    check(x + y, u + v);
    check(x - y, u - v);
    check(-x, -u);
    check(x * y, u * v);
    check(x * y - x * z, u * v - u * w);
    check(gcd(x, y), gcd(u, v));
    CHECK(Integer(long_product(u, v)) == x * y);
    if (z.is_zero()) continue;
    if ((x * z).bits() <= Fixed::value_bits && (y * z).bits() <= Fixed::value_bits) {
      Fixed p(x * z), q(y * z);
      check(gcd(x * z, y * z), gcd(p, q));
      divide_exactly({&p, &q}, w);
      check(x, p);
      check(y, q);
    }
  }
  return fitting;
}

}  // namespace

TEST_CASE("integers of fixed width are right wherever the result fits, up to the last bit") {
  CHECK(fitting_results<1>() > 10000);
  CHECK(fitting_results<2>() > 10000);
  CHECK(fitting_results<4>() > 10000);
}

TEST_CASE("bit lengths of sums and products bound those of the numbers, also where all are as long as they may be") {
  Lengths draw(200);
  for (int i = 0; i < 3000; ++i) {
    const Integer x = draw.number(), y = draw.number(), z = draw.number();
    const BitLength a(x), b(y), c(z);
    CHECK((x * y).bits() <= (a * b).bits);
    CHECK((x * y + z).bits() <= (a * b + c).bits);
    CHECK((x * y - z * z).bits() <= (a * b - c * c).bits);
    CHECK((-x).bits() <= (-a).bits);
  }
  CHECK(BitLength(0).bits == 0);
  CHECK(BitLength(-1).bits == 1);
  CHECK((BitLength(0) * BitLength(7)).bits == 0);
}
