// Scenes on which number types give different answers.
#pragma once

#include "floating/trade/trade.hpp"
#include "floating/trade/traded.hpp"

namespace slipproof {

struct Workload : TradeWorkload {
  const TradedMechanism* mechanism = nullptr;
  std::vector<TradeScene> scenes;
};

/// The workloads of `slipproof trade`, divided into pieces. Each piece is drawn independently: the same seed gives the
/// same scenes.
struct Workloads {
  static constexpr std::size_t piece_size = 500;

  std::size_t count;  ///< number of scenes in each workload
  std::uint64_t seed;

  static std::size_t size();
  std::size_t pieces() const { return (count + piece_size - 1) / piece_size; }  ///< number of pieces of each workload
  Workload make(std::size_t index, std::size_t piece = 0) const;
};

}  // namespace slipproof
