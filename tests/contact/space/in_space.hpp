// A planar mechanism of bodies, put into space: x to the right stays, y up becomes z, and a turn counterclockwise one
// about -y.
#pragma once

#include <optional>
#include <string>

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof::test {

/// The text of its file, or nothing where space has no such parts: friction elements, guides with friction, a static
/// coefficient of its own, one-sided gears.
std::optional<std::string> in_space(const Mechanism& planar);

}  // namespace slipproof::test
