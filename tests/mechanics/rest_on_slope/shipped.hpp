// Bodies and their six numbers, read from proofs/rest-on-slope/claims.toml.
#pragma once

#include <string>
#include <vector>

#include "mechanics/rest_on_slope/lyapunov.hpp"

namespace slipproof::test::rest_on_slope {

struct Point {
  std::string id;
  Body body;  ///< without a slope
  Numbers numbers;
};

/// The settings "point 1", "point 2", ...
std::vector<Point> shipped_points();
/// Those of the region.
Numbers shipped_numbers();

}  // namespace slipproof::test::rest_on_slope
