// Many scenes at once, as a structure of arrays.
#pragma once

#include <span>

#include "filter/filter.hpp"

namespace slipproof {

/// One number of each scene; of length 1: the same for all scenes.
using Column = std::span<const double>;

/// consistent_modes() of every scene, the numbers taken exactly. All columns have the length of `answers`, or 1; throws
/// std::invalid_argument otherwise. `threads`: 0 for all there are. Adds to `counts` which tier decided how many
/// scenes. Allocates only where a scene needs the exact tier or a second thread.
void consistent_modes(const ForcedScene<Column>& scenes, std::span<ConsistentModes> answers, TierCounts& counts,
                      unsigned threads = 1);

}  // namespace slipproof
