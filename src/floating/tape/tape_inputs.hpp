// What a mechanism says of the inputs of its tape.
#pragma once

#include <utility>
#include <vector>

#include "floating/program/tape.hpp"
#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// Parameters, cosine and sine of each angle, the load: as far as their own domains say.
std::vector<InputSign> input_signs(const Mechanism& mechanism);
/// Cosine and sine of each angle among them.
std::vector<std::pair<std::size_t, std::size_t>> circles(const Mechanism& mechanism);

}  // namespace slipproof
