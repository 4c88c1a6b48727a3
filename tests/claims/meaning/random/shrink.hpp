// Makes a claims file smaller as long as it still shows what it is to show: for people to read.
#pragma once

#include <functional>

#include "claims/meaning/second_judge/claims.hpp"

namespace slipproof::meaning {

using Shows = std::function<bool(const File&, std::size_t claim)>;

/// With the index of the claim in it.
std::pair<File, std::size_t> shrunk(File file, std::size_t claim, const Shows& shows);

}  // namespace slipproof::meaning
