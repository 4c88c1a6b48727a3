// The filter beside the same enumeration of modes in plain binary64, which tolerates what it cannot know.
#include "filter/filter.hpp"

#include <benchmark/benchmark.h>

#include "filter/batch.hpp"
#include "filter/vector_clones.hpp"
#include "number/binary64.hpp"
#include "support/filter_scenes.hpp"

namespace {

using namespace slipproof;
using test::FilterScenes;

/// binary64 as everybody uses it: zero and everything above a small negative number count as positive.
struct Unchecked {
  double x = 0;
  Unchecked() = default;
  explicit Unchecked(int constant) : x(constant) {}
  static Unchecked input(double value) {
    Unchecked u;
    u.x = value;
    return u;
  }
  friend Unchecked operator+(Unchecked a, Unchecked b) { return input(a.x + b.x); }
  friend Unchecked operator-(Unchecked a, Unchecked b) { return input(a.x - b.x); }
  friend Unchecked operator*(Unchecked a, Unchecked b) { return input(a.x * b.x); }
  friend Unchecked operator-(Unchecked a) { return input(-a.x); }
};
bool certainly_positive(Unchecked u) {
  return u.x > -1e-12;
}
bool certainly_negative(Unchecked u) {
  return !certainly_positive(u);
}

std::vector<ForcedScene<double>> scenes(bool detachment, int threshold_bits) {
  FilterScenes random(101);
  std::vector<ForcedScene<double>> result;
  while (result.size() < 4096) {
    ForcedScene<Rational> exact = random.scene(test::Population::bicycles);
    if (detachment && !exact.bicycle.J) continue;
    if (!detachment) exact.bicycle.J.reset();
    auto s = nearest_binary64(exact);
    if (threshold_bits == 0) {
      s.F = random.signed_log(1, 3000);
    } else {
      const test::ForceOracle oracle(exact);
      const auto& ends = oracle.ends();
      s.F = ends[random.next() % ends.size()] * (1 + std::ldexp(random.coin() ? 1 : -1, -threshold_bits));
    }
    result.push_back(s);
  }
  return result;
}

template <class Solve>
void each(benchmark::State& state, const std::vector<ForcedScene<double>>& all, const Solve& solve) {
  std::size_t i = 0;
  unsigned seen = 0;
  for (auto _ : state) {
    seen += solve(all[i]);
    i = (i + 1) % all.size();
  }
  benchmark::DoNotOptimize(seen);
}

/// Inlined and compiled as the filter is, so that the two differ in nothing but the bounds.
SLIPPROOF_VECTOR_CLONES("avx2")
[[gnu::flatten, gnu::noinline]] unsigned plain(const ForcedScene<double>& s) {
  return decide_modes(tracked_dynamics<Unchecked>(s), s.bicycle.J.has_value()).consistent;
}

[[gnu::noinline]] unsigned filtered(const ForcedScene<double>& s) {
  const ModeSets sets = filter_modes(s);
  return sets.undecided == 0 ? sets.consistent : consistent_modes(s).consistent;
}

/// Arguments: detachment, bits of the distance from a threshold (0: typical).
void one_plain(benchmark::State& state) {
  each(state, scenes(state.range(0) != 0, static_cast<int>(state.range(1))), plain);
}
void one_filtered(benchmark::State& state) {
  const auto all = scenes(state.range(0) != 0, static_cast<int>(state.range(1)));
  for (const auto& s : all) {
    if (filter_modes(s).undecided == 0 && consistent_modes(to_rational(s)).consistent != filtered(s)) {
      state.SkipWithError("differs");
    }
  }
  each(state, all, filtered);
  std::size_t undecided = 0;
  for (const auto& s : all) undecided += filter_modes(s).undecided != 0;
  state.counters["undecided"] = static_cast<double>(undecided) / static_cast<double>(all.size());
}
void one_double_double(benchmark::State& state) {
  each(state, scenes(state.range(0) != 0, static_cast<int>(state.range(1))),
       [](const auto& s) { return double_double_modes(s).consistent; });
}
void one_exact(benchmark::State& state) {
  each(state, scenes(state.range(0) != 0, static_cast<int>(state.range(1))),
       [](const auto& s) { return exact_modes(to_rational(s)).consistent; });
}
BENCHMARK(one_plain)->ArgsProduct({{0, 1}, {0, 40}});
BENCHMARK(one_filtered)->ArgsProduct({{0, 1}, {0, 40}});
BENCHMARK(one_double_double)->ArgsProduct({{0, 1}, {0}});
BENCHMARK(one_exact)->ArgsProduct({{0, 1}, {0}});

/// Arguments: detachment, threads.
void batch(benchmark::State& state) {
  const bool detachment = state.range(0) != 0;
  const auto all = scenes(detachment, 0);
  test::SceneColumns columns;
  while (columns.size() < (1U << 17U)) {
    for (auto s : all) {
      s.force_kind = ForceKind::internal;
      columns.add(s);
    }
  }
  const ForcedScene<Column> scene = columns.scenes();
  std::vector<ConsistentModes> answers(columns.size());
  TierCounts counts{};
  for (auto _ : state) consistent_modes(scene, answers, counts, static_cast<unsigned>(state.range(1)));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(columns.size()));
}
BENCHMARK(batch)->ArgsProduct({{0, 1}, {1, 2}})->UseRealTime();

}  // namespace
