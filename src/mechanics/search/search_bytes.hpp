// Messages between ranks of a search.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/crew/bytes.hpp"
#include "mechanics/search/search.hpp"

namespace slipproof {

/// What one sample shows.
struct Shown {
  enum class End : std::uint8_t { no_point, no_value, found } end = End::no_point;
  bool one_everywhere = true, realisable = false;
  std::set<MotionCount> counts;
  EnergyBalance energy = EnergyBalance::not_judged;
  std::vector<std::pair<FoundMotions, SearchPlace>> places;  ///< each set of motions once, by load
};

std::string shown_bytes(const Shown& shown);
std::string cell_bytes(const SearchCell& cell);
/// What was written. Throw BrokenBytes.
Shown read_shown(std::string_view bytes);
SearchCell read_cell(std::string_view bytes);

}  // namespace slipproof
