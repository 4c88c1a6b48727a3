// Siconos's enumeration and Lemke solvers beside the exact solver, on the same scenes.
#include "support/siconos.hpp"

#include <benchmark/benchmark.h>

#include "support/bicycle/motions.hpp"
#include "support/bicycle_populations.hpp"

namespace {

using namespace slipproof;

const std::vector<ForcedScene<double>>& scenes() {
  static const auto all = [] {
    test::RandomBicycles random(101);
    std::vector<ForcedScene<double>> result;
    while (result.size() < 256) {
      result.push_back(random.typical());
      if (!result.back().bicycle.J) result.pop_back();
    }
    return result;
  }();
  return all;
}

/// The problem is made beforehand; the share of answers that the solver calls a success is a counter.
template <class Problem>
void siconos(benchmark::State& state, int solver) {
  std::vector<Problem> problems;
  for (const auto& s : scenes()) problems.emplace_back(test::ContactProblem(s));
  const auto options = test::siconos_options(solver);
  std::size_t i = 0;
  double solved = 0;
  for (auto _ : state) solved += problems[i++ % problems.size()].solve(options.get()).info == 0;
  state.counters["success"] = solved / static_cast<double>(state.iterations());
}
void siconos_lcp(benchmark::State& state, int solver) {
  siconos<test::ContactLcp>(state, solver);
}
BENCHMARK_CAPTURE(siconos_lcp, enum, SICONOS_LCP_ENUM)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(siconos_lcp, lemke, SICONOS_LCP_LEMKE)->Unit(benchmark::kMicrosecond);

void siconos_fc2d(benchmark::State& state, int solver) {
  siconos<test::PlanarFriction>(state, solver);
}
BENCHMARK_CAPTURE(siconos_fc2d, enum, SICONOS_FRICTION_2D_ENUM)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(siconos_fc2d, lemke, SICONOS_FRICTION_2D_LEMKE)->Unit(benchmark::kMicrosecond);

void siconos_scenes_exact(benchmark::State& state) {
  std::size_t i = 0;
  for (auto _ : state) {
    const auto s = to_rational(scenes()[i++ % scenes().size()]);
    benchmark::DoNotOptimize(motions_at(ModeTable(s.bicycle, s.road, s.force_kind), s.F));
  }
}
BENCHMARK(siconos_scenes_exact)->Unit(benchmark::kMicrosecond);

}  // namespace
