// A mechanism with further conditions on its domain.
#pragma once

#include <string_view>

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// The same mechanism where a condition holds, such as `b < h and mu < 1`: over parameters, angle symbols and
/// definitions, an entry of [assume] more; what is joined by `and` and has the load in it must bound the load, whose
/// domain it narrows. Throws InputError, with the column in the text, for a text that is no condition, for unknown
/// names, and for bounds of the load that are no interval; `source` is how messages call the text.
Mechanism narrowed(const Mechanism& mechanism, std::string_view condition, const std::string& source);

}  // namespace slipproof
