// Krawczyk's test in long numbers, for equations that are too close to dependent for binary64.
#pragma once

#include <optional>

#include "base/number/effort.hpp"
#include "contact/enclosure/enclosure.hpp"
#include "contact/path/follow.hpp"

namespace slipproof {

/// The exact solution near the end of a path, by Coulomb's law: an approximate inverse in numbers of 106 bits, and the
/// test and the conditions of the mode without rounding, so that matrices may have a condition of 10^28. Of up to 40
/// equations the exact inverse is tried, too. Where 106 bits could not tell the mode of a small problem, a contact that
/// sticks outside of its cone slides instead. Equations that are exactly dependent are dropped as in enclosure.hpp. The
/// enclosure has its `proof`. Nothing where the test or a condition fails. Cubic in the size of a block where A is
/// full. Throws TooMuchWork.
std::optional<Enclosure> enclose_in_long_numbers(const MixedProblem& problem, PathEnd end, Effort& effort);

}  // namespace slipproof
