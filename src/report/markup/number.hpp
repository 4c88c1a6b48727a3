// Lengths in pictures.
#pragma once

#include <string>

namespace slipproof {

/// At most two decimals, no trailing zeros, never "-0".
std::string short_number(double value);

}  // namespace slipproof
