// The filter beside the same enumeration of modes in plain binary64, which tolerates what it cannot know.
#include "floating/filter/filter.hpp"

#include <benchmark/benchmark.h>

#include <string>

#include "base/number/binary64.hpp"
#include "floating/filter/batch.hpp"
#include "floating/filter/lanes.hpp"
#include "floating/filter/vector_kernel.hpp"
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
[[gnu::noinline]] unsigned plain(const ForcedScene<double>& s) {
  return in_registers_of_four(
      [&] { return unsigned{decide_modes(tracked_dynamics<Unchecked>(s), s.bicycle.J.has_value()).consistent}; });
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

/// As decide_lanes(), with a tolerance in place of bounds: nothing is undecided.
template <class V>
BitsOf<V> plain_lanes(const ReducedDynamics<PlainLanes<V>, PlainLanes<V>>& dynamics, bool detachment) {
  using N = PlainLanes<V>;
  using Words = typename LaneTypes<width_of<V>>::Words;
  Words fail{};
  std::uint64_t modes = 0;
  const auto judge = [&]<std::size_t index>() {
    constexpr ContactMode mode = all_modes()[index];
    constexpr ConditionList list = condition_list(mode);
    const ReducedMotion<N, N> motion(dynamics, mode);
    const BitsOf<V> orientation = bits(motion.determinant().value) & sign_bit<V>();
    V least{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(list.count); ++i) {
      const V side = motion.condition_value(list.items[i]).numerator.value;
      const V value = from_bits(BitsOf<V>(bits(side) ^ orientation));
      least = i == 0 ? value : smaller(least, value);
    }
    modes |= std::uint64_t{1} << index;
    fail |= reinterpret_cast<Words>(bits(V(1e-12 + least))) >> 63 << index;
  };
  each_modelled(detachment, judge);
  return reinterpret_cast<BitsOf<V>>(Words(modes & ~fail));
}

struct PlainBatch {
  template <int width>
  static void run(const ForcedScene<Column>& scenes, std::span<ConsistentModes> answers) {
    using V = typename LaneTypes<width>::Numbers;
    using N = PlainLanes<V>;
    for (std::size_t i = 0; i + width <= answers.size(); i += width) {
      const auto s = convert<Column, N>(scenes, [i](const Column& column) {
        return N::input(column.size() == 1 ? in_all_lanes<V>(column[0]) : load<V>(column.data() + i));
      });
      const auto dynamics = reduce<N, N>(s.bicycle, s.road, s.force_kind, s.F, N(1));
      const auto modes = plain_lanes<V>(dynamics, s.bicycle.J.has_value());
      for (int lane = 0; lane < width; ++lane) {
        const auto set = static_cast<std::uint16_t>(modes[lane]);
        answers[i + static_cast<std::size_t>(lane)] = {set, set, Tier::filter};
      }
    }
  }
};

/// `solve` of many scenes, as columns; arguments: detachment, ...
template <class Solve>
void each_batch(benchmark::State& state, const Solve& solve) {
  test::SceneColumns columns;
  const auto all = scenes(state.range(0) != 0, 0);
  while (columns.size() < (1U << 17U)) {
    for (auto s : all) {
      s.force_kind = ForceKind::internal;
      columns.add(s);
    }
  }
  const ForcedScene<Column> scene = columns.scenes();
  std::vector<ConsistentModes> answers(columns.size());
  for (auto _ : state) {
    solve(scene, std::span<ConsistentModes>(answers));
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(columns.size()));
}

Registers registers_of(std::int64_t numbers) {
  return numbers == 8 ? Registers::eight : numbers == 4 ? Registers::four : Registers::two;
}
/// More arguments: numbers in a register, threads.
void batch(benchmark::State& state) {
  const Registers registers = registers_of(state.range(1));
  each_batch(state, [&](const ForcedScene<Column>& scene, std::span<ConsistentModes> answers) {
    TierCounts counts{};
    consistent_modes(scene, answers, counts, static_cast<unsigned>(state.range(2)), registers);
  });
}
void plain_batch(benchmark::State& state) {
  const Registers registers = registers_of(state.range(1));
  each_batch(state, [&](const ForcedScene<Column>& scene, std::span<ConsistentModes> answers) {
    VectorKernel<PlainBatch>::run(registers, scene, answers);
  });
}
/// For each kind of registers that is available; what is left out stands in the context that is printed.
void in_each_kind(benchmark::internal::Benchmark* measured, const std::vector<std::int64_t>& threads) {
  for (const std::int64_t numbers : {2, 4, 8}) {
    if (available(registers_of(numbers))) {
      measured->ArgsProduct({{0, 1}, {numbers}, threads});
    } else {
      benchmark::AddCustomContext("registers of " + std::to_string(numbers) + " numbers", "not available, left out");
    }
  }
  measured->UseRealTime();
}
BENCHMARK(batch)->Apply([](auto* measured) { in_each_kind(measured, {1, 2}); });
BENCHMARK(plain_batch)->Apply([](auto* measured) { in_each_kind(measured, {1}); });

}  // namespace
