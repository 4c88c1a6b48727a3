// "Did you mean": the known name that a misspelt one is nearest to.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace slipproof {

/// The first of the nearest `candidates`: at most two letters inserted, left out, changed or swapped, and at most half
/// of the word; the case of letters counts least. Nothing when none is near.
std::optional<std::string_view> near_match(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace slipproof
