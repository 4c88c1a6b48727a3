#include "floating/filter/batch.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>

#include "base/parallel/in_parallel.hpp"
#include "floating/filter/lanes.hpp"
#include "floating/filter/size_check.hpp"
#include "floating/filter/vector_kernel.hpp"

namespace slipproof {

namespace {

/// Where what decide_lanes() says of scenes goes to.
using FoundSets = std::span<std::int64_t>;

/// Undecided also where a number is outside of what the bounds are for.
template <class V>
BitsOf<V> store(const BitsOf<V>& sets, const BitsOf<V>& outside, std::int64_t* to) {
  const BitsOf<V> result = sets | (outside & sign_bit<V>());
  std::memcpy(to, &result, sizeof result);
  return result;
}

/// A block of scenes, each with its own bounds.
struct DecideBlock {
  template <int width>
  static void run(const ForcedScene<LaneNumbers>& scenes, FoundSets sets) {
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
  return column.size() == 1 ? in_all_lanes<V>(column[0]) : load<V>(column.data() + scene);
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
        most = larger(smaller(x, in_all_lanes<V>(input_limit)), most);
        if (column.size() == 1) break;
      }
      double size = 0;
      for (int lane = 0; lane < width; ++lane) size = std::max(size, most[lane]);
      return std::clamp(2 * size, std::numeric_limits<double>::min(), input_limit);
    });
  }
};

/// Bounds for all scenes that are smaller in every number than one.
struct SizedBounds {
  Sizes sizes;
  SharedBounds bounds;

  explicit SizedBounds(const ForcedScene<double>& largest)
      : bounds(tracked_dynamics<Magnitude>(largest), largest.bicycle.J.has_value()) {
    std::size_t number = 0;
    convert<double, double>(largest, [&](double size) {
      sizes.set(number++, size);
      return size;
    });
  }
};

/// The scenes of a chunk by bounds that they share; those that are larger are undecided. And whether any is.
struct DecideChunk {
  template <int width>
  static void run(const Chunk& chunk, const SizedBounds& shared, FoundSets sets, bool& all_decided) {
    using V = typename LaneTypes<width>::Numbers;
    using N = PlainLanes<V>;
    BitsOf<V> any{};
    for (std::size_t i = 0; i < chunk.blocks * lane_count; i += width) {
      SizeCheck<V> check(shared.sizes);
      const auto s = convert<Column, N>(chunk.scenes, [&](const Column& column) {
        const V x = lanes_at<V>(column, chunk.first + i);
        check.add(x);
        return N::input(x);
      });
      const auto dynamics = reduce<N, N>(s.bicycle, s.road, s.force_kind, s.F, N(1));
      const auto found = decide_lanes<V>(dynamics, s.bicycle.J.has_value(), CommonBounds<V>{shared.bounds});
      any |= store<V>(found, check.outside(), &sets[i]);
    }
    std::int64_t signs = 0;
    for (int lane = 0; lane < width; ++lane) signs |= any[lane];
    all_decided = signs >= 0;
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
    bool all = bounds_ && share_bounds(chunk);
    if (!bounds_ || (!all && often_undecided(chunk))) {
      ForcedScene<double> sizes;
      VectorKernel<LargestOfChunk>::run(registers_, chunk, sizes);
      bounds_.emplace(sizes);
      all = share_bounds(chunk);
    }
    std::size_t first = begin;
    if (all) {
      first += chunk.blocks * lane_count;
      pass_on(std::span(sets_).first(first - begin), begin);
    }
    for (; first < end; first += lane_count) {
      decide_block(std::span(sets_).subspan(first - begin, lane_count), first,
                   std::min<std::size_t>(lane_count, end - first));
    }
  }

  /// Whether all are decided.
  bool share_bounds(const Chunk& chunk) {
    bool all = false;
    VectorKernel<DecideChunk>::run(registers_, chunk, *bounds_, FoundSets(sets_), all);
    return all;
  }
  bool often_undecided(const Chunk& chunk) const {
    std::size_t blocks = 0;
    for (std::size_t i = 0; i < chunk.blocks; ++i) blocks += has_undecided(&sets_[i * lane_count]);
    return 4 * blocks > chunk.blocks;
  }
  static bool has_undecided(const std::int64_t* block) {
    std::int64_t any = 0;
    for (std::size_t lane = 0; lane < lane_count; ++lane) any |= block[lane];
    return any < 0;
  }

  /// The first `count` scenes of a block that shared bounds may leave undecided, or that is cut.
  void decide_block(FoundSets sets, std::size_t first, std::size_t count) {
    if (count < lane_count || has_undecided(sets.data())) {
      VectorKernel<DecideBlock>::run(registers_, block_of(scenes_, first, answers_.size()), sets);
    }
    pass_on(sets.first(count), first);
    for (std::size_t lane = 0; lane < count; ++lane) {
      if (sets[lane] >= 0) continue;
      --counts_[static_cast<std::size_t>(Tier::filter)];
      answers_[first + lane] = consistent_modes(scene_at(scenes_, first + lane));
      ++counts_[static_cast<std::size_t>(answers_[first + lane].tier)];
    }
  }

  /// As decided by the filter.
  void pass_on(FoundSets sets, std::size_t first) {
    ConsistentModes* const answers = &answers_[first];
    for (std::size_t i = 0; i < sets.size(); ++i) {
      const auto modes = static_cast<std::uint16_t>(sets[i]);
      answers[i] = {modes, modes, Tier::filter};
    }
    counts_[static_cast<std::size_t>(Tier::filter)] += sets.size();
  }

  const ForcedScene<Column>& scenes_;
  std::span<ConsistentModes> answers_;
  Registers registers_;
  TierCounts counts_{};
  std::optional<SizedBounds> bounds_;  ///< of a chunk before
  std::array<std::int64_t, chunk_scenes> sets_;
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
  std::array<std::int64_t, lane_count> found;
  VectorKernel<DecideBlock>::run(widest_registers(), scenes, FoundSets(found));
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
