// Arithmetic in binary64 gives the same bits on every machine only without contraction of a*b+c: exit 0 if this was
// compiled so, 1 if not.
#include <cstdio>
#include <random>

#include "floating/tape/running_error.hpp"

using namespace slipproof;

int main() {
  std::mt19937_64 engine(81);
  int wrong_signs = 0;
  for (int i = 0; i < 10000; ++i) {
    const auto draw = [&] { return 1 + static_cast<double>(engine() >> 11) * 0x1p-53; };
    const double x = draw(), y = draw();
    const auto number = [](double value) { return RunningError{Lanes{} + value, Lanes{}}; };
    // x y - (2 x) (y / 2) is 0; contracted, it is the rounding error of one of the products.
    const RunningError difference = number(x) * number(y) - number(2 * x) * number(y / 2);
    if (difference.value[0] != 0) ++wrong_signs;
  }
  std::printf("differences that are not zero: %d of 10000\n", wrong_signs);
  return wrong_signs == 0 ? 0 : 1;
}
