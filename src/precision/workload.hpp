// Scenes on which number types part ways.
#pragma once

#include "precision/trade.hpp"

namespace slipproof {

struct Workload : TradeWorkload {
  std::vector<ForcedScene<Rational>> scenes;
};

/// The workloads of `slipproof trade`, with `count` scenes each; the same seed gives the same scenes.
class Workloads {
 public:
  Workloads(std::size_t count, std::uint64_t seed);

  std::size_t size() const { return makers_.size(); }
  Workload make(std::size_t index) const;

 private:
  using Maker = std::function<ForcedScene<Rational>(class SceneDraw&)>;
  void add(TradeWorkload workload, Maker maker) { makers_.emplace_back(std::move(workload), std::move(maker)); }

  std::size_t count_;
  std::uint64_t seed_;
  std::vector<std::pair<TradeWorkload, Maker>> makers_;
};

}  // namespace slipproof
