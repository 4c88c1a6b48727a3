// Reads a measurement of `slipproof trade --json`.
#pragma once

#include <filesystem>

#include "floating/trade/trade.hpp"

namespace slipproof {

/// Reads `slipproof/trade/1`. Throws InputError.
Trade read_trade(const std::filesystem::path& path);

}  // namespace slipproof
