// The report of `slipproof trade`.
#pragma once

#include <string>
#include <vector>

#include "floating/trade/trade.hpp"
#include "report/document/document.hpp"

namespace slipproof {

/// One JSON document, schema slipproof/trade/1, ending in a newline. An infinite number is null.
std::string trade_json(const Trade& trade);

/// All measurements, a table for each workload.
std::vector<ReportTable> workload_tables(const Trade& trade);

/// These tables, then one of the types over all workloads. The status is `s MEASURED`, or `s REFUTED` if the filter was
/// wrong.
Document trade_document(const Trade& trade);

}  // namespace slipproof
