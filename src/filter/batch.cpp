#include "filter/batch.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "filter/lanes.hpp"
#include "filter/vector_clones.hpp"
#include "parallel/in_parallel.hpp"

namespace slipproof {

namespace {

SLIPPROOF_VECTOR_CLONES("avx512f", "avx2")
SLIPPROOF_FLATTEN void decide_block(const ForcedScene<LaneNumbers>& scenes, LaneSets& sets) {
  LaneBits within{};
  within = ~within;
  const auto s = convert<LaneNumbers, TrackedLanes>(scenes, [&](const LaneNumbers& numbers) {
    const Lanes x = load(numbers);
    within &= absolute(x) <= input_limit;
    return TrackedLanes::input(x);
  });
  const auto dynamics = reduce<TrackedLanes, TrackedLanes>(s.bicycle, s.road, s.force_kind, s.F, TrackedLanes(1));
  sets = decide_lanes(dynamics, s.bicycle.J.has_value());
  sets.undecided |= ~within;
}

/// Scenes `first` to `first` + lane_count - 1; the last scene again where there are no more.
ForcedScene<LaneNumbers> block_of(const ForcedScene<Column>& scenes, std::size_t first, std::size_t count) {
  return convert<Column, LaneNumbers>(scenes, [&](const Column& column) {
    LaneNumbers x;
    if (column.size() == 1) {
      x.of.fill(column[0]);
    } else {
      for (std::size_t lane = 0; lane < lane_count; ++lane) x.of[lane] = column[std::min(first + lane, count - 1)];
    }
    return x;
  });
}

ForcedScene<double> scene_at(const ForcedScene<Column>& scenes, std::size_t i) {
  return convert<Column, double>(scenes, [i](const Column& c) { return c[i]; });
}

TierCounts decide_range(const ForcedScene<Column>& scenes, std::span<ConsistentModes> answers, std::size_t begin,
                        std::size_t end) {
  TierCounts counts{};
  for (std::size_t first = begin; first < end; first += lane_count) {
    stop_if_asked();
    LaneSets sets;
    decide_block(block_of(scenes, first, answers.size()), sets);
    for (std::size_t i = first; i < std::min<std::size_t>(end, first + lane_count); ++i) {
      const auto modes = static_cast<std::uint16_t>(sets.consistent[i - first]);
      answers[i] = {modes, modes, Tier::filter};
      if (sets.undecided[i - first] != 0) answers[i] = consistent_modes(scene_at(scenes, i));
      ++counts[static_cast<std::size_t>(answers[i].tier)];
    }
  }
  return counts;
}

void check_lengths(const ForcedScene<Column>& scenes, std::size_t count) {
  convert<Column, Column>(scenes, [count](const Column& c) {
    if (c.size() != 1 && c.size() != count) throw std::invalid_argument("a column of neither one nor all scenes");
    return c;
  });
}

TierCounts sum(TierCounts x, const TierCounts& y) {
  for (std::size_t i = 0; i < tier_count; ++i) x[i] += y[i];
  return x;
}

}  // namespace

void filter_lanes(const ForcedScene<LaneNumbers>& scenes, std::array<ModeSets, lane_count>& sets) {
  LaneSets found;
  decide_block(scenes, found);
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    sets[lane] = {static_cast<std::uint16_t>(found.consistent[lane]),
                  static_cast<std::uint16_t>(found.undecided[lane])};
  }
}

void consistent_modes(const ForcedScene<Column>& scenes, std::span<ConsistentModes> answers, TierCounts& counts,
                      unsigned threads) {
  check_lengths(scenes, answers.size());
  const auto decide = [&](std::size_t begin, std::size_t end) { return decide_range(scenes, answers, begin, end); };
  if (threads == 1) {
    counts = sum(counts, decide(0, answers.size()));
    return;
  }
  constexpr std::size_t grain = 1024;
  const std::size_t blocks = (answers.size() + lane_count - 1) / lane_count;  // a block of lanes is never cut
  const TierCounts found = on_threads(threads, [&, token = StopScope::token()] {
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, blocks, grain / lane_count), TierCounts{},
        [&](const tbb::blocked_range<std::size_t>& r, const TierCounts& so_far) {
          const StopScope scope(token);
          return sum(so_far, decide(r.begin() * lane_count, std::min(r.end() * lane_count, answers.size())));
        },
        sum);
  });
  counts = sum(counts, found);
}

BatchAnswers consistent_modes(const ForcedScene<Column>& scenes, unsigned threads) {
  std::size_t count = 0;
  convert<Column, Column>(scenes, [&count](const Column& c) {
    count = std::max(count, c.size());
    return c;
  });
  BatchAnswers answers{std::vector<ConsistentModes>(count), {}};
  consistent_modes(scenes, answers.modes, answers.tiers, threads);
  return answers;
}

}  // namespace slipproof
