// The map of proofs/rest-on-slope: for which bodies rest is proved to be stable.
#pragma once

#include <string>
#include <vector>

#include "mechanics/rest_on_slope/shipped.hpp"

namespace slipproof::test::rest_on_slope {

/// What map.svg should contain: the region, the points, and the body that tips, by u and mu h.
std::string map_picture(const std::vector<Point>& points, const Body& tipping);

}  // namespace slipproof::test::rest_on_slope
