// The units in which a mechanism's results are, as far as its file tells.
#pragma once

#include <string>
#include <vector>

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// Of acceleration_names(), in its order; empty where it is not known. A gap or slip has the unit of an acceleration
/// that it contains as it is.
std::vector<std::string> acceleration_units(const Mechanism& mechanism);

/// Of force_names(), in its order. Of a scene of bodies in kg and m, forces of contacts are in N.
std::vector<std::string> force_units(const Mechanism& mechanism);

/// ` N`; nothing for a plain number, or where the unit is not known.
std::string unit_suffix(const std::string& unit);

}  // namespace slipproof
