// Many bicycles at once: a shorthand for points of the shipped mechanism `bicycle`.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "floating/batch/mechanism_batch.hpp"

namespace slipproof {

/// A column for each number: one value for each bicycle, or one for all. J may be missing.
struct BicycleColumns {
  static constexpr std::array<std::string_view, 14> symbols{"M",  "R",  "h",  "b2", "b3", "I1", "I2",
                                                            "I3", "r1", "r2", "L",  "J",  "f",  "g"};
  std::array<Column, 14> numbers;  ///< in the order of these symbols
  Column F;
  bool external = false;  ///< somebody who is not on the bicycle pushes the pedal

  /// The first required column that has no number; empty if there is none.
  std::string_view missing() const;
};

/// For each bicycle, bit 4 i + j stands for the rear wheel in state i and the front wheel in state j, of stick, slip+,
/// slip-, lift: modes with a motion, and modes in which a motion holds all conditions strictly.
struct BicycleModes {
  std::vector<std::uint16_t> consistent, strict;
  std::vector<Tier> tiers;  ///< which tier decided each bicycle

  TierCounts counts() const;
};

/// Without J no wheel leaves the road. `threads`: 0 for as many as there are. Throws std::invalid_argument for a
/// missing column, for one of neither one nor all bicycles, and for the first bicycle outside the domain, with its
/// number from `first` on.
BicycleModes consistent_modes(const BicycleColumns& bicycles, unsigned threads = 0, std::size_t first = 1);

}  // namespace slipproof
