// One exact solve of all 16 contact modes over alpha + beta F, beside the same by Eigen on the raw equations.
#include <benchmark/benchmark.h>

#include "bench/examples.hpp"
#include "mechanics/bicycle_modes/motions.hpp"
#include "support/raw_solver.hpp"

namespace {

using namespace slipproof;
using test::Example;
using test::examples;

std::size_t solve_with_eigen(const Example& e) {
  std::size_t regular = 0;
  for (const ContactMode mode : all_modes()) {
    regular += test::solve_raw(e.bicycle, e.road, ForceKind::internal, mode).has_value() ? 1 : 0;
  }
  return regular;
}

void exact_all_modes_intervals(benchmark::State& state) {
  std::size_t i = 0;
  for (auto _ : state) {
    const Example& e = examples()[i++ % examples().size()];
    benchmark::DoNotOptimize(ModeTable(e.bicycle, e.road, ForceKind::internal));
  }
}
BENCHMARK(exact_all_modes_intervals)->Unit(benchmark::kMicrosecond);

/// With every quantity of every mode as a function of F, its 13 pairs of fractions in lowest terms, from the parameters
/// of the scene on: what Eigen gives, and more than the 11 pairs that flint_raw_all_modes ends with.
void exact_all_modes_motions(benchmark::State& state) {
  for (const Example& e : examples()) {
    const ModeTable table(e.bicycle, e.road, ForceKind::internal);
    for (const ModeSolution& s : table.solutions()) {
      if (s.motion() != test::solve_raw(e.bicycle, e.road, ForceKind::internal, s.mode())) {
        state.SkipWithError("the two solvers disagree");
        return;
      }
    }
  }
  std::size_t i = 0;
  for (auto _ : state) {
    const Example& e = examples()[i++ % examples().size()];
    const ModeTable table(e.bicycle, e.road, ForceKind::internal);
    for (const ModeSolution& s : table.solutions()) benchmark::DoNotOptimize(s.motion());
  }
}
BENCHMARK(exact_all_modes_motions)->Unit(benchmark::kMicrosecond);

void eigen_full_piv_lu_raw_all_modes(benchmark::State& state) {
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(solve_with_eigen(examples()[i++ % examples().size()]));
}
BENCHMARK(eigen_full_piv_lu_raw_all_modes)->Unit(benchmark::kMicrosecond);

void exact_partition(benchmark::State& state) {
  std::size_t i = 0;
  for (auto _ : state) {
    const Example& e = examples()[i++ % examples().size()];
    benchmark::DoNotOptimize(partition(ModeTable(e.bicycle, e.road, ForceKind::internal)));
  }
}
BENCHMARK(exact_partition)->Unit(benchmark::kMicrosecond);

}  // namespace
