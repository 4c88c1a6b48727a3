// What `slipproof trade` found, as JSON and as text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "floating/trade/trade.hpp"
#include "report/document/document.hpp"

namespace slipproof {

/// One JSON document, schema slipproof/trade/1, ending in a newline. What is infinite is null.
std::string trade_json(const Trade& trade);

/// One type over all workloads; its speed and error are those on the first, which is the typical one.
struct TradeTotal {
  std::size_t scenes = 0, wrong = 0, undecided = 0;
  double typical_speed = 0, typical_error = 0;
  std::optional<int> first_wrong_bits;  ///< k of the first workload at 2^-k from a threshold with a wrong answer
};
TradeTotal total(const Trade& trade, const std::string& type);

/// All measurements, a table for each workload.
std::vector<ReportTable> workload_tables(const Trade& trade);

/// These, then the types over all workloads. The status is `s MEASURED`, or `s REFUTED` where the filter was wrong.
Document trade_document(const Trade& trade);

}  // namespace slipproof
