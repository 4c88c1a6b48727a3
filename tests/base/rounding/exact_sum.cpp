#include "base/rounding/exact_sum.hpp"

#include <doctest/doctest.h>

#include <cfenv>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "base/number/binary64.hpp"

using namespace slipproof;

namespace {

struct Product {
  double a, b;
};

/// The sum by rationals, and by the accumulator.
void check_sum(const std::vector<Product>& products) {
  Rational expected = 0;
  ExactSum sum;
  for (const auto& [a, b] : products) {
    expected += to_rational(a) * to_rational(b);
    sum.add(a, b);
  }
  CHECK(sum.value() == expected);
  CHECK(sum.nearest() == nearest_binary64(expected));
}

}  // namespace

TEST_CASE("a sum of products is exact, and rounds as a rational does") {
  std::mt19937_64 random(31);
  const auto number = [&](int range) {
    const double mantissa = std::ldexp(static_cast<double>(random() >> 11), -53) - 0.5;
    return std::ldexp(mantissa, static_cast<int>(random() % static_cast<unsigned>(2 * range + 1)) - range);
  };
  for (int i = 0; i < 4000; ++i) {
    const int range = i % 4 == 0 ? 500 : i % 4 == 1 ? 40 : 2;
    std::vector<Product> products;
    for (auto n = random() % 8; n-- > 0;) products.push_back({number(range), number(range)});
    check_sum(products);
    for (std::size_t k = products.size(); k-- > 0;) products.push_back({-products[k].a, products[k].b});
    check_sum(products);  // 0
    products.push_back({number(range), number(range)});
    check_sum(products);  // what the others leave
  }
}

TEST_CASE("ties, carries and the ends of the range of a sum of products round as a rational does") {
  const double ulp = std::numeric_limits<double>::epsilon(), tiny = std::numeric_limits<double>::denorm_min();
  const double huge = std::numeric_limits<double>::max();
  for (const double sign : {1.0, -1.0}) {
    for (const double off : {0.0, ulp * ulp, -ulp * ulp, 0x1p-900, -0x1p-900}) {
      check_sum({{sign, 1}, {sign * ulp, 0.5}, {off, 1}});
      check_sum({{sign, 1 + ulp}, {sign * ulp, 0.5}, {off, 1}});
      check_sum({{sign, 0x1p64}, {-sign, 1}, {off, 1}});
      check_sum({{sign, 0x1p32}, {sign, 0x1p-32}, {off, 1}});
    }
    check_sum({{sign * tiny, 1}, {tiny, tiny}});
    check_sum({{sign * tiny, tiny}});
    check_sum({{sign * 0x1p-1022, 1}, {tiny, 0.5}});
    check_sum({{sign * huge, 0.5}, {sign * huge, 0.25}});
    check_sum({{sign * huge, huge}, {-sign * huge, huge}, {sign, 3}});
  }
  CHECK(ExactSum().nearest() == 0);
}

TEST_CASE("a sum of products rounds to nearest in any rounding mode") {
  ExactSum sum;
  sum.add(1);
  sum.add(0x1p-60);
  const int before = std::fegetround();
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const double nearest = sum.nearest();
    std::fesetround(before);
    CHECK(nearest == 1);
  }
}
