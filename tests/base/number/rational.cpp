#include "base/number/rational.hpp"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <random>
#include <sstream>

using namespace slipproof;

namespace {

/// Numbers of all lengths, with many near the ends of 31, 62, 63 and 64 bits, where their form in memory changes.
class Draw {
 public:
  mpz_class integer() {
    static constexpr int lengths[] = {0, 1, 5, 31, 32, 61, 62, 63, 64, 65, 127, 128, 300};
    mpz_class x = 1;
    x <<= static_cast<unsigned>(lengths[number(0, std::size(lengths) - 1)]);
    x += number(0, 4) - 2;
    if (number(0, 3) == 0) {
      const mpz_class factor = number(1, 1'000'000);
      x *= factor;
    }
    return number(0, 1) == 0 ? x : mpz_class(-x);
  }
  mpq_class rational() {
    mpz_class divisor = integer();
    if (divisor == 0 || number(0, 3) == 0) divisor = 1;
    mpq_class x(integer(), divisor);
    x.canonicalize();
    return x;
  }
  long number(long low, long high) {
    return low + static_cast<long>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::mt19937_64 engine_{19};
};

Integer ours(const mpz_class& x) {
  return Integer(x.get_mpz_t());
}
Rational ours(const mpq_class& x) {
  return Rational(x.get_mpq_t());
}

template <class Ours, class Gmp>
void compare_ring(const Gmp& x, const Gmp& y) {
  const Ours a = ours(x), b = ours(y);
  CHECK(a == ours(x));
  CHECK(Ours(a + b).str() == Gmp(x + y).get_str());
  CHECK(Ours(a - b).str() == Gmp(x - y).get_str());
  CHECK(Ours(a * b).str() == Gmp(x * y).get_str());
  CHECK(Ours(-a).str() == Gmp(-x).get_str());
  CHECK(abs(a).str() == Gmp(abs(x)).get_str());
  const int order = cmp(x, y);
  CHECK(a.compare(b) == (order > 0) - (order < 0));
  CHECK((a == b) == (order == 0));
  CHECK((a < b) == (order < 0));
  CHECK((a >= b) == (order >= 0));
  CHECK(a.sign() == sgn(x));
  CHECK(a.is_zero() == (x == 0));
  CHECK(a.to_double() == x.get_d());
  Ours c = a;
  c += b;
  c *= c;
  c -= a;
  CHECK(c.str() == Gmp((x + y) * (x + y) - x).get_str());
  CHECK(Ours(Ours(a) + b - b).str() == x.get_str());
}

}  // namespace

TEST_CASE("integers are GMP's, in whatever form they are kept") {
  Draw draw;
  for (int i = 0; i < 5'000; ++i) {
    const mpz_class x = draw.integer(), y = draw.integer();
    CAPTURE(x.get_str());
    CAPTURE(y.get_str());
    compare_ring<Integer>(x, y);
    const Integer a = ours(x), b = ours(y);
    CHECK(gcd(a, b).str() == mpz_class(gcd(x, y)).get_str());
    CHECK(lcm(a, b).str() == mpz_class(lcm(x, y)).get_str());
    CHECK(a.bits() == (x == 0 ? 0 : mpz_sizeinbase(x.get_mpz_t(), 2)));
    CHECK(a.fits_long() == x.fits_slong_p());
    if (x.fits_slong_p()) CHECK(a.to_long() == x.get_si());
    CHECK(a.is_odd() == (mpz_odd_p(x.get_mpz_t()) != 0));
    CHECK(Integer(a << 70U).str() == mpz_class(x << 70U).get_str());
    CHECK(Integer(a >> 3U).str() == mpz_class(x / 8).get_str());
    CHECK(Integer(x.get_str(16), 16) == a);
    CHECK(a.str(16) == x.get_str(16));
    CHECK(mpz_cmp(GmpInteger(a).get(), x.get_mpz_t()) == 0);
    if (x >= 0) CHECK(sqrt(a).str() == mpz_class(sqrt(x)).get_str());
    if (y == 0) continue;
    CHECK(Integer(a / b).str() == mpz_class(x / y).get_str());
    CHECK(Integer(a % b).str() == mpz_class(x % y).get_str());
    const auto [quotient, remainder] = divide(a, b);
    CHECK(quotient == a / b);
    CHECK(remainder == a % b);
    CHECK(exact_quotient(a * b, b) == a);
    Integer sum = a;
    sum.add_product(a, b);
    CHECK(sum.str() == mpz_class(x + x * y).get_str());
    sum.subtract_product(b, b);
    CHECK(sum.str() == mpz_class(x + x * y - y * y).get_str());
  }
}

TEST_CASE("rational numbers are GMP's, in lowest terms") {
  Draw draw;
  for (int i = 0; i < 5'000; ++i) {
    const mpq_class x = draw.rational(), y = draw.rational();
    CAPTURE(x.get_str());
    CAPTURE(y.get_str());
    compare_ring<Rational>(x, y);
    const Rational a = ours(x), b = ours(y);
    CHECK(numerator(a) == ours(mpz_class(x.get_num())));
    CHECK(denominator(a) == ours(mpz_class(x.get_den())));
    CHECK(Rational(x.get_str()) == a);
    CHECK(mpq_equal(GmpRational(a).get(), x.get_mpq_t()) != 0);
    CHECK(pow(a, 3) == a * a * a);
    if (y == 0) continue;
    CHECK(Rational(a / b).str() == mpq_class(x / y).get_str());
    CHECK(pow(b, -2) * b * b == 1);
    const mpz_class divisor = draw.integer();
    if (divisor == 0) continue;
    mpq_class quotient(x.get_num(), divisor);
    quotient.canonicalize();
    CHECK(Rational(numerator(a), ours(divisor)).str() == quotient.get_str());
  }
}

TEST_CASE("numbers outlive what they were made from") {
  Integer big = pow(Integer(10), 40);
  const Integer copy = big, moved = std::move(big);
  big = 7;
  CHECK(copy == moved);
  CHECK(big == 7);
  Rational x(copy, 3), y = 1;
  swap(x, y);
  CHECK(x == 1);
  CHECK(y * 3 == Rational(copy));
  const Integer top = numerator(Rational(y * 3));
  CHECK(top == copy);
  y = y;
  CHECK(y * 3 == Rational(copy));
  std::ostringstream out;
  out << x << ' ' << Rational(-3, 4) << ' ' << Integer(-5);
  CHECK(out.str() == "1 -3/4 -5");
}

TEST_CASE("what is not a number, or has none as its value, is refused") {
  for (const char* text : {"", "-", "+1", "1.5", "0x10", " 1", "1 ", "1e3", "12a"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(Integer{std::string(text)}, std::invalid_argument);
  }
  CHECK_THROWS_AS(Integer("1g", 16), std::invalid_argument);
  CHECK_THROWS_AS(Rational("1/"), std::invalid_argument);
  CHECK_THROWS_AS(Rational("1/2/3"), std::invalid_argument);
  CHECK_THROWS_AS(Rational("1/0"), std::overflow_error);
  CHECK(times_power_of_two(3, -5) == Rational(3, 32));
  CHECK(times_power_of_two(12, -3) == Rational(3, 2));
  CHECK(times_power_of_two(-3, 70) == -3 * pow(Rational(2), 70));
  CHECK_THROWS_AS(Rational(1, 0), std::overflow_error);
  CHECK_THROWS_AS(Rational(1) / 0, std::overflow_error);
  CHECK_THROWS_AS(Integer(1) / 0, std::overflow_error);
  CHECK_THROWS_AS(Integer(1) % 0, std::overflow_error);
  CHECK_THROWS_AS(divide(1, 0), std::overflow_error);
  CHECK_THROWS_AS(pow(Rational(0), -1), std::overflow_error);
  CHECK_THROWS_AS(sqrt(Integer(-1)), std::domain_error);
}
