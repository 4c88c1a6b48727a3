// What a mechanism's file says about the inputs of its tape.
#pragma once

#include <utility>
#include <vector>

#include "floating/program/tape.hpp"
#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// The signs of the parameters, of cosine and sine of each angle, and of the load, so far as their own domains give
/// them.
std::vector<InputSign> input_signs(const Mechanism& mechanism);
/// The pairs of inputs that are cosine and sine of an angle.
std::vector<std::pair<std::size_t, std::size_t>> circles(const Mechanism& mechanism);

}  // namespace slipproof
