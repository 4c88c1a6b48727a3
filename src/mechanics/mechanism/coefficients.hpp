// What has a value at each point of a mechanism.
#pragma once

#include <vector>

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// All numbers in the forms of equations, links, contacts and friction elements, but those that are absent, and the
/// coefficients of friction. Over the mechanism's parameters, definitions and angle symbols.
std::vector<Expression> coefficients(const Mechanism& mechanism);

}  // namespace slipproof
