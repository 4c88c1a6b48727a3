// Where motions change along a parameter, if they can only be found at single values of it: in space.
#pragma once

#include <functional>

#include "mechanics/planes/phase_diagram.hpp"

namespace slipproof {

/// Motions at values of x, in its order: evenly spaced ones, and where two neighbours differ values that enclose the
/// change. What changes and changes back between two neighbours that are alike is not seen.
struct SetsAlong {
  struct Place {
    Rational x;
    std::optional<MotionSet> set;  ///< nothing outside of the domain
  };
  Axis x;
  std::vector<Place> places;

  /// From one value to the next that differs, the motions are the same: indices of places.
  std::vector<std::pair<std::size_t, std::size_t>> runs() const;
  bool is_complete() const;
};

/// At the ends of so many parts of the axis; a change is halved until it is narrower than a 1024th of such a part.
SetsAlong sets_along(const Axis& x, std::size_t parts,
                     const std::function<std::optional<MotionSet>(const Rational& x)>& solve,
                     const std::function<void(std::uint64_t done, std::uint64_t all)>& progress);

}  // namespace slipproof
