// The output of `slipproof trade`, as JSON and as text.
#pragma once

#include <string>

#include "floating/trade/trade.hpp"

namespace slipproof {

/// One JSON document, schema slipproof/trade/1, ending in a newline. An infinite number is null.
std::string trade_json(const Trade& trade);

/// A table for each workload, then one of the types over all workloads.
std::string trade_text(const Trade& trade);

}  // namespace slipproof
