// A mechanism with further conditions on its domain.
#pragma once

#include <string_view>

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// Restricts a mechanism to where a condition holds, such as `b < h and mu < 1`. Conjuncts over parameters, angle
/// symbols and definitions become an entry of [assume]; conjuncts with the load must bound it, and narrow its domain.
/// Throws InputError, with the column in the text, if the text is not a condition, for unknown names, and for bounds of
/// the load that are not an interval. `source` is the name of the text in messages.
Mechanism narrowed(const Mechanism& mechanism, std::string_view condition, const std::string& source);

}  // namespace slipproof
