// What has a value at each point of a mechanism.
#pragma once

#include <vector>

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// All nonzero coefficients in the forms of equations, links, contacts and friction elements, and the coefficients of
/// friction. They are expressions in the mechanism's parameters, definitions and angle symbols.
std::vector<Expression> coefficients(const Mechanism& mechanism);

}  // namespace slipproof
