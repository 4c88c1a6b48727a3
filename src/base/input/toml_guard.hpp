// What is no text, or would be too deep for toml++, found before it is read.
#pragma once

#include <string_view>

#include "base/input/diagnostic.hpp"

namespace slipproof {

/// Reports to `mistakes` the first byte that is not UTF-8, or the first key of more than 16 parts, and returns true if
/// there is neither. toml++ makes a table of each part and recurses over nested tables, so a long enough key would
/// overflow the stack.
bool fit_for_tomlplusplus(std::string_view text, Mistakes& mistakes);

}  // namespace slipproof
