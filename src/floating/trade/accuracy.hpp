// What the number types get right and wrong, in pieces that are added up: for threads, and for ranks.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "floating/trade/trade.hpp"
#include "floating/trade/workload.hpp"

namespace slipproof {

/// Digits lost by one type, by decade of the condition number.
class Cancellations {
 public:
  void add(double condition, double digits_lost);
  void add(const Cancellations& later);
  void append_to(std::vector<Cancellation>& all, const std::string& type) const;

 private:
  friend std::string accuracy_bytes(const std::vector<struct Accuracy>& types);
  friend std::vector<struct Accuracy> read_accuracy(std::string_view bytes);

  static constexpr std::size_t decade_count = 41;
  std::array<Cancellation, decade_count> decades_;  ///< the mean is their sum, until it is told
};

/// What one type did on scenes of one workload: a row without its speed.
struct Accuracy {
  TradeRow row;
  Cancellations cancellations;

  /// Of scenes that follow. In their order the sums are the same bits each time.
  void add(const Accuracy& later);
};

/// Of each type, in their order.
std::vector<Accuracy> judge_accuracy(const Workload& workload);

/// Without the names of workload and type.
std::string accuracy_bytes(const std::vector<Accuracy>& types);
/// Throws BrokenBytes.
std::vector<Accuracy> read_accuracy(std::string_view bytes);

}  // namespace slipproof
