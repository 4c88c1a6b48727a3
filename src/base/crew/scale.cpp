#include "base/crew/scale.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <queue>
#include <random>
#include <utility>

#include "base/crew/crew.hpp"

namespace slipproof {

namespace {

constexpr std::uint64_t on_the_way = 2;

/// Answers that reach rank 0, by time and by who sends them.
using Arrivals = std::priority_queue<std::pair<double, std::uint64_t>, std::vector<std::pair<double, std::uint64_t>>,
                                     std::greater<>>;

/// Simulates one stage of a crew, event by event.
class PlayedStage {
 public:
  PlayedStage(const MeasuredWork& work, std::uint64_t cores, std::uint64_t seed)
      : work_(work),
        engine_(seed),
        helped_(cores <= static_cast<std::uint64_t>(most_ranks_helped)),
        free_at_(helped_ ? cores : cores - 1, 0.0) {}

  double seconds() {
    for (std::uint64_t i = 0; i < on_the_way; ++i) {
      for (std::uint64_t rank = 0; rank < free_at_.size(); ++rank) ask(rank, 0);
    }
    const double service = work_.handling + work_.bytes * work_.seconds_a_byte;
    double now = 0;
    while (!arrivals_.empty()) {
      const auto [time, rank] = arrivals_.top();
      arrivals_.pop();
      now = std::max(now, time) + service;
      if (helped_) free_at_[0] += service;  // which cannot compute meanwhile
      ask(rank, now);
    }
    return now;
  }
  double computed() const { return computed_; }
  double longest() const { return longest_; }

 private:
  void ask(std::uint64_t rank, double now) {
    if (asked_ == work_.count) return;
    ++asked_;
    const double takes = work_.requests[engine_() % work_.requests.size()];
    free_at_[rank] = std::max(free_at_[rank], now + work_.latency) + takes;
    computed_ += takes;
    longest_ = std::max(longest_, takes);
    arrivals_.emplace(free_at_[rank] + work_.latency, rank);
  }

  const MeasuredWork& work_;
  std::mt19937_64 engine_;
  bool helped_;                  ///< by rank 0
  std::vector<double> free_at_;  ///< by rank, when it has done what it was asked
  Arrivals arrivals_;
  std::uint64_t asked_ = 0;
  double computed_ = 0, longest_ = 0;
};

}  // namespace

std::string_view name(Bottleneck bottleneck) {
  constexpr std::array<std::string_view, 4> names{"the cores", "rank 0, which takes the results",
                                                  "what rank 0 does alone", "the longest requests"};
  return names[static_cast<std::size_t>(bottleneck)];
}

PredictedRun predict(const MeasuredWork& work, std::uint64_t cores, std::uint64_t seed) {
  PlayedStage stage(work, cores, seed);
  const double played = stage.seconds();
  PredictedRun run;
  run.seconds = work.alone + played;
  const double taking = static_cast<double>(work.count) * (work.handling + work.bytes * work.seconds_a_byte);
  run.efficiency = (work.alone + stage.computed() + taking) / (run.seconds * static_cast<double>(cores));
  const double busy = stage.computed() / static_cast<double>(cores);
  const std::array bounds{std::pair(busy, Bottleneck::none), std::pair(taking, Bottleneck::rank_0),
                          std::pair(work.alone, Bottleneck::alone), std::pair(stage.longest(), Bottleneck::longest)};
  run.bottleneck = std::max_element(bounds.begin(), bounds.end())->second;
  return run;
}

}  // namespace slipproof
