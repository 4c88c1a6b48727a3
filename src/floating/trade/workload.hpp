// Scenes on which number types part ways.
#pragma once

#include "floating/trade/trade.hpp"

namespace slipproof {

struct Workload : TradeWorkload {
  std::vector<ForcedScene<Rational>> scenes;
};

/// The workloads of `slipproof trade`, with `count` scenes each, in pieces of which each is drawn by itself; the same
/// seed gives the same scenes.
class Workloads {
 public:
  static constexpr std::size_t piece_size = 500;

  Workloads(std::size_t count, std::uint64_t seed);

  std::size_t size() const { return makers_.size(); }
  std::size_t pieces() const { return (count_ + piece_size - 1) / piece_size; }  ///< of each workload
  Workload make(std::size_t index, std::size_t piece = 0) const;

 private:
  using Maker = std::function<ForcedScene<Rational>(class SceneDraw&)>;
  void add(TradeWorkload workload, Maker maker) { makers_.emplace_back(std::move(workload), std::move(maker)); }

  std::size_t count_;
  std::uint64_t seed_;
  std::vector<std::pair<TradeWorkload, Maker>> makers_;
};

}  // namespace slipproof
