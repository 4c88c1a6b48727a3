// Mechanism files, written.
#pragma once

#include <string>

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// A mechanism file that reads back as the same mechanism, by its equations: also of one that was given by bodies,
/// whose equations, gaps, slips and pictures it writes down.
std::string to_toml(const Mechanism& mechanism);

}  // namespace slipproof
