// How accurate the number types are. Results are pieces that can be added, by threads and by ranks.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "floating/trade/trade.hpp"
#include "floating/trade/workload.hpp"

namespace slipproof {

/// What one type did on scenes of one workload: a row of the result without its speed.
struct Accuracy {
  TradeRow row;
  std::array<Cancellation, 41> decades{};  ///< by condition number; each mean holds a sum until tell_cancellations()

  /// Adds a quantity.
  void add(double condition, double digits_lost);
  /// Appends the decades that have quantities to `all`.
  void tell_cancellations(const std::string& type, std::vector<Cancellation>& all) const;
};

/// The accuracy of each type, in the order of the types.
std::vector<Accuracy> judge_accuracy(const Workload& workload);

/// The results as bytes, without the names of workload and type.
std::string accuracy_bytes(const std::vector<Accuracy>& types);
/// Adds the results of the scenes that follow. Added in the order of the scenes, the sums are always the same bits.
/// Throws BrokenBytes.
void add_accuracy(std::string_view bytes, std::vector<Accuracy>& types);

}  // namespace slipproof
