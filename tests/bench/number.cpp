#include <benchmark/benchmark.h>

#include "base/number/rational.hpp"

namespace {

using slipproof::Rational;

void rational_sum(benchmark::State& state) {
  const Rational x(355, 113);
  const Rational y(103993, 33102);
  if (x + y - y != x) state.SkipWithError("x + y - y is not x");
  for (auto _ : state) benchmark::DoNotOptimize(Rational(x + y));
}
BENCHMARK(rational_sum);

}  // namespace
