// Siconos's enumeration and Lemke solvers beside the exact solver, on the same scenes.
#include "support/siconos.hpp"

#include <benchmark/benchmark.h>

#include "contact/enclosure/known_problem.hpp"
#include "support/bicycle/motions.hpp"
#include "support/scenes/bicycle_populations.hpp"

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

/// What NSGS takes to find the answer of a row of balls, to 1e-8, where W's diagonal exceeds its row by `own`/2: beside
/// `sweeps_find` and `enclosure_of_what_sweeps_find`.
void siconos_nsgs(benchmark::State& state) {
  Dice dice(3, static_cast<std::uint64_t>(state.range(0)));
  const auto contacts = static_cast<std::size_t>(state.range(0));
  const test::KnownProblem made = test::coupled_contacts(dice, contacts, 1, 0.5);
  const MixedProblem& p = made.problem;
  const int n = static_cast<int>(p.size());
  const std::unique_ptr<NumericsMatrix, decltype(&NM_free)> W(NM_create(NM_SPARSE, n, n), NM_free);
  NM_triplet_alloc(W.get(), static_cast<CS_INT>(p.A.entries()));
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t e = p.A.starts[i]; e < p.A.starts[i + 1]; ++e) {
      NM_entry(W.get(), static_cast<int>(i), static_cast<int>(p.A.column[e]), p.A.value[e]);
    }
  }
  std::vector<double> q = p.c, mu = p.mu;
  FrictionContactProblem problem{};
  problem.dimension = 3;
  problem.numberOfContacts = static_cast<int>(contacts);
  problem.M = W.get();
  problem.q = q.data();
  problem.mu = mu.data();
  const auto options = test::siconos_options(SICONOS_FRICTION_3D_NSGS);
  options->dparam[SICONOS_DPARAM_TOL] = 1e-8;
  options->iparam[SICONOS_IPARAM_MAX_ITER] = 100'000;
  int info = 0;
  for (auto _ : state) {
    std::vector<double> r(q.size()), u(q.size());
    info = fc3d_driver(&problem, r.data(), u.data(), options.get());
  }
  state.counters["failed"] = info;
  state.counters["iterations"] = options->iparam[SICONOS_IPARAM_ITER_DONE];
}
BENCHMARK(siconos_nsgs)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

}  // namespace
