#include "filter/batch.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <optional>
#include <stdexcept>

#include "filter/lanes.hpp"
#include "filter/vector_kernel.hpp"
#include "parallel/in_parallel.hpp"

namespace slipproof {

namespace {

/// What decide_lanes() says of lane_count scenes.
using BlockSets = std::array<std::int64_t, lane_count>;

/// Undecided also where a number is outside of what the bounds are for.
template <class V>
void store(const BitsOf<V>& sets, const BitsOf<V>& outside, std::int64_t* to) {
  const BitsOf<V> result = sets | (outside & sign_bit<V>());
  std::memcpy(to, &result, sizeof result);
}

/// A block of scenes, each with its own bounds.
struct DecideBlock {
  template <int width>
  static void run(const ForcedScene<LaneNumbers>& scenes, BlockSets& sets) {
    using V = typename LaneTypes<width>::Numbers;
    using N = TrackedLanes<V>;
    for (std::size_t lane = 0; lane < lane_count; lane += width) {
      BitsOf<V> outside{};
      const auto s = convert<LaneNumbers, N>(scenes, [&](const LaneNumbers& numbers) {
        const V x = load<V>(&numbers.of[lane]);
        outside |= beyond(x, input_limit);
        return N::input(x);
      });
      const auto dynamics = reduce<N, N>(s.bicycle, s.road, s.force_kind, s.F, N(1));
      store<V>(decide_lanes<V>(dynamics, s.bicycle.J.has_value(), OwnBounds<V>{}), outside, &sets[lane]);
    }
  }
};

/// As many scenes as may share their bounds: their numbers fit into the fastest cache.
constexpr std::size_t chunk_scenes = 256;

/// The scenes of some columns, from one of them on.
struct Chunk {
  const ForcedScene<Column>& scenes;
  std::size_t first, blocks;  ///< blocks of lane_count scenes each, none cut
};

template <class V>
V lanes_at(const Column& column, std::size_t scene) {
  return column.size() == 1 ? V{} + column[0] : load<V>(column.data() + scene);
}

/// The largest magnitudes of a chunk, twice, so that they serve for scenes of the same kind, but within the limit.
struct LargestOfChunk {
  template <int width>
  static void run(const Chunk& chunk, ForcedScene<double>& sizes) {
    using V = typename LaneTypes<width>::Numbers;
    const std::size_t end = chunk.first + chunk.blocks * lane_count;
    sizes = convert<Column, double>(chunk.scenes, [&](const Column& column) {
      V most{};
      for (std::size_t i = chunk.first; i < end; i += width) {
        const V x = absolute(lanes_at<V>(column, i));
        most = larger(smaller(x, V(V{} + input_limit)), most);
        if (column.size() == 1) break;
      }
      double size = 0;
      for (int lane = 0; lane < width; ++lane) size = std::max(size, most[lane]);
      return std::min(2 * size, input_limit);
    });
  }
};

/// Bounds for all scenes that are no larger in any number than one, in the order in which convert() goes through them.
struct SizedBounds {
  std::array<double, 15> sizes{};
  SharedBounds bounds;

  explicit SizedBounds(const ForcedScene<double>& largest)
      : bounds(tracked_dynamics<Magnitude>(largest), largest.bicycle.J.has_value()) {
    std::size_t number = 0;
    convert<double, double>(largest, [&](double size) { return sizes[number++] = size; });
  }
};

/// The scenes of a chunk by bounds that they share; those that are larger are undecided.
struct DecideChunk {
  template <int width>
  static void run(const Chunk& chunk, const SizedBounds& shared, std::span<BlockSets> sets) {
    using V = typename LaneTypes<width>::Numbers;
    using N = PlainLanes<V>;
    for (std::size_t i = 0; i < chunk.blocks * lane_count; i += width) {
      BitsOf<V> outside{};
      std::size_t number = 0;
      const auto s = convert<Column, N>(chunk.scenes, [&](const Column& column) {
        const V x = lanes_at<V>(column, chunk.first + i);
        outside |= beyond(x, shared.sizes[number++]);
        return N::input(x);
      });
      const auto dynamics = reduce<N, N>(s.bicycle, s.road, s.force_kind, s.F, N(1));
      const auto found = decide_lanes<V>(dynamics, s.bicycle.J.has_value(), CommonBounds<V>{shared.bounds});
      store<V>(found, outside, &sets[i / lane_count][i % lane_count]);
    }
  }
};

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

/// The answers for a column of scenes in one kind of registers.
class BatchFilter {
 public:
  BatchFilter(const ForcedScene<Column>& scenes, std::span<ConsistentModes> answers, Registers registers)
      : scenes_(scenes), answers_(answers), registers_(registers) {}

  /// Of scenes `begin` to `end` - 1.
  TierCounts decide(std::size_t begin, std::size_t end) {
    counts_ = {};
    for (std::size_t first = begin; first < end; first += chunk_scenes) {
      stop_if_asked();
      decide_chunk(first, std::min(end, first + chunk_scenes));
    }
    return counts_;
  }

 private:
  /// By shared bounds, which cost next to nothing; where scenes of a block are undecided, or too few for a block are
  /// left, by each number's own. What shared bounds decide the others would, too: they are never larger.
  void decide_chunk(std::size_t begin, std::size_t end) {
    const Chunk chunk{scenes_, begin, (end - begin) / lane_count};
    const std::span<BlockSets> shared(sets_.data(), chunk.blocks);
    if (bounds_) VectorKernel<DecideChunk>::run(registers_, chunk, *bounds_, shared);
    if (!bounds_ || 4 * std::ranges::count_if(shared, has_undecided) > std::ssize(shared)) {
      ForcedScene<double> sizes;
      VectorKernel<LargestOfChunk>::run(registers_, chunk, sizes);
      bounds_.emplace(sizes);
      VectorKernel<DecideChunk>::run(registers_, chunk, *bounds_, shared);
    }
    for (std::size_t block = 0; block * lane_count < end - begin; ++block) {
      const std::size_t first = begin + block * lane_count, count = std::min<std::size_t>(lane_count, end - first);
      if (count < lane_count || has_undecided(sets_[block])) {
        const auto numbers = block_of(scenes_, first, answers_.size());
        VectorKernel<DecideBlock>::run(registers_, numbers, sets_[block]);
      }
      answer(sets_[block], first, count);
    }
  }

  static bool has_undecided(const BlockSets& sets) {
    std::int64_t any = 0;
    for (const std::int64_t modes : sets) any |= modes;
    return any < 0;
  }

  /// What the lanes know of a block's scenes, and the other tiers of the rest.
  void answer(const BlockSets& sets, std::size_t first, std::size_t count) {
    ConsistentModes* const answers = &answers_[first];
    const auto put = [&](std::size_t lane) {
      const auto modes = static_cast<std::uint16_t>(sets[lane]);
      answers[lane] = {modes, modes, Tier::filter};
    };
    if (count == lane_count) {
#pragma GCC unroll 8
      for (std::size_t lane = 0; lane < lane_count; ++lane) put(lane);
    } else {
      for (std::size_t lane = 0; lane < count; ++lane) put(lane);
    }
    counts_[static_cast<std::size_t>(Tier::filter)] += count;
    if (!has_undecided(sets)) return;
    for (std::size_t lane = 0; lane < count; ++lane) {
      if (sets[lane] >= 0) continue;
      --counts_[static_cast<std::size_t>(Tier::filter)];
      answers[lane] = consistent_modes(scene_at(scenes_, first + lane));
      ++counts_[static_cast<std::size_t>(answers[lane].tier)];
    }
  }

  const ForcedScene<Column>& scenes_;
  std::span<ConsistentModes> answers_;
  Registers registers_;
  TierCounts counts_{};
  std::optional<SizedBounds> bounds_;  ///< of a chunk before
  std::array<BlockSets, chunk_scenes / lane_count> sets_;
};

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
  BlockSets found;
  VectorKernel<DecideBlock>::run(widest_registers(), scenes, found);
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    sets[lane] = found[lane] < 0 ? all_undecided : ModeSets{static_cast<std::uint16_t>(found[lane]), 0};
  }
}

void consistent_modes(const ForcedScene<Column>& scenes, std::span<ConsistentModes> answers, TierCounts& counts,
                      unsigned threads, Registers registers) {
  check_lengths(scenes, answers.size());
  const auto decide = [&](std::size_t begin, std::size_t end) {
    return BatchFilter(scenes, answers, registers).decide(begin, end);
  };
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
