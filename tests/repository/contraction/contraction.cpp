// The filter's arithmetic gives the same bits on every machine only without contraction of a*b+c: exit 0 if this was
// compiled so, 1 if not.
#include <cstdio>
#include <random>

#include "floating/filter/double_double.hpp"
#include "floating/filter/tracked.hpp"

using namespace slipproof;

int main() {
  std::mt19937_64 engine(81);
  int wrong_products = 0, wrong_signs = 0;
  for (int i = 0; i < 10000; ++i) {
    const auto draw = [&] { return 1 + static_cast<double>(engine() >> 11) * 0x1p-53; };
    const double x = draw(), y = draw();
    const DoubleDouble p = two_product(x, y);
    if (to_rational(p.high) + to_rational(p.low) != to_rational(x) * to_rational(y)) ++wrong_products;
    // x y - (2 x) (y / 2) is 0; contracted, it is the rounding error of one of the products.
    const Tracked difference = Tracked::input(x) * Tracked::input(y) - Tracked::input(2 * x) * Tracked::input(y / 2);
    if (difference.value() != 0) ++wrong_signs;
  }
  std::printf("products that are not exact: %d, differences that are not zero: %d of 10000\n", wrong_products,
              wrong_signs);
  return wrong_products + wrong_signs == 0 ? 0 : 1;
}
