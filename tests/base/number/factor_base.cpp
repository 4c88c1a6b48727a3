// Irreducible factors of many polynomials, against each one factored by itself.
#include "base/algebra/factor_base.hpp"

#include <doctest/doctest.h>
#include <flint/fmpz_poly_factor.h>

#include <random>
#include <vector>

using namespace slipproof;

namespace {

bool always(const IntegerPolynomial&) {
  return true;
}

/// From the constant up.
IntegerPolynomial ascending(const std::vector<int>& coefficients) {
  IntegerPolynomial result, power(1);
  for (const int c : coefficients) {
    result = result + power * IntegerPolynomial(c);
    power = power * IntegerPolynomial(Integer(0), Integer(1));
  }
  return result;
}

void add_factors(const IntegerPolynomial& p, std::set<IntegerPolynomial>& factors) {
  fmpz_poly_factor_t factored;
  fmpz_poly_factor_init(factored);
  fmpz_poly_factor(factored, p.flint());
  for (slong i = 0; i < factored->num; ++i) {
    IntegerPolynomial factor;
    fmpz_poly_set(factor.flint(), factored->p + i);
    factors.insert(factor.primitive());
  }
  fmpz_poly_factor_clear(factored);
}

class PolynomialDraw {
 public:
  IntegerPolynomial polynomial(int degree, int size) {
    std::vector<int> coefficients;
    for (int i = 0; i <= degree; ++i) coefficients.push_back(number(-size, size));
    coefficients.back() = number(1, size);
    return ascending(coefficients);
  }
  int number(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }

 private:
  std::mt19937 engine_{61};
};

}  // namespace

TEST_CASE("factor base: the factors of each polynomial by itself, whatever is known before") {
  PolynomialDraw draw;
  for (int round = 0; round < 20; ++round) {
    FactorBase base;
    std::set<IntegerPolynomial> expected;
    std::vector<IntegerPolynomial> pool;
    for (int i = 0; i < 6; ++i) pool.push_back(draw.polynomial(draw.number(1, 4), 9));
    for (int i = 0; i < 20; ++i) {
      IntegerPolynomial p = draw.polynomial(draw.number(0, 6), 40);
      for (int k = draw.number(0, 3); k > 0; --k) p = p * pool[static_cast<std::size_t>(draw.number(0, 5))];
      base.add(p, always);
      add_factors(p, expected);
      CHECK(base.factors() == expected);
    }
  }
}

TEST_CASE("factor base: few divisions of hundreds of polynomials by hundreds of others") {
  PolynomialDraw draw;
  FactorBase base;
  const IntegerPolynomial shared = ascending({-2, 0, 0, 1});
  std::uint64_t polynomials = 0;
  for (int i = 0; i < 400; ++i, ++polynomials) base.add(shared * draw.polynomial(8, 1'000'000), always);
  CHECK(base.factors().size() > 390);
  // Trial division takes 400*399/2 long divisions. Each polynomial but the first has one known factor, now and then a
  // second one.
  CHECK(base.divisions() >= polynomials - 1);
  CHECK(base.divisions() < polynomials + 40);
  CHECK(base.remainders() < polynomials * 70);
}

TEST_CASE("factor base: few polynomials are factored where each shared factor is in 1 of 100") {
  PolynomialDraw draw;
  FactorBase base;
  std::vector<IntegerPolynomial> shared;
  for (int i = 0; i < 100; ++i) shared.push_back(ascending({-2 - i, 0, 0, i + 1, 0, 1}));
  const std::uint64_t polynomials = 1500;
  for (std::uint64_t i = 0; i < polynomials; ++i) base.add(shared[i % 100] * draw.polynomial(8, 1'000'000), always);
  // Each shared factor is found, given up, and found once more.
  CHECK(base.factors().size() > polynomials);
  CHECK(base.factored() >= 100);
  CHECK(base.factored() < 400);  // a few more since six primes do not show every irreducible one
  CHECK(base.remainders() < polynomials * 200);
}

TEST_CASE("factor base: a factor that vanishes modulo the prime, or whose leading coefficient does") {
  const Integer prime = Integer((1L << 61) - 1);
  const IntegerPolynomial vanishing = IntegerPolynomial(prime) * ascending({1, 1}), lower(Integer(1), prime);
  FactorBase base;
  base.add(lower, always);
  base.add(lower * lower * ascending({3, 0, 1}), always);
  base.add(vanishing, always);
  base.add(vanishing * ascending({1, 0, 1}), always);
  CHECK(base.factors() ==
        std::set<IntegerPolynomial>{lower, ascending({1, 1}), ascending({3, 0, 1}), ascending({1, 0, 1})});
}

TEST_CASE("factor base: what does not matter is not factored") {
  FactorBase base;
  base.add(ascending({-1, 1}), always);
  int asked = 0;
  base.add(ascending({-1, 1}) * ascending({1, 0, 1}), [&](const IntegerPolynomial& rest) {
    ++asked;
    CHECK(rest == ascending({1, 0, 1}));
    return false;
  });
  CHECK(asked == 1);
  CHECK(base.factors() == std::set<IntegerPolynomial>{ascending({-1, 1})});
}
