// Regions of a phase diagram that are too thin to see, and enlargements that show them.
#pragma once

#include <optional>
#include <vector>

#include "report/phase/axis.hpp"
#include "report/phase/phase_regions.hpp"

namespace slipproof {

/// In pixels; a thinner region is drawn as wide as this.
inline constexpr double least_seen = 4;

struct ThinRegion {
  std::size_t set = 0;  ///< index into the regions' sets
  PlanePoint at;        ///< where it is thickest
  bool line = false;    ///< it is only in single columns, so no enlargement makes it wider
  std::optional<std::size_t> enlargement;
};

/// A part of a diagram, solved again with columns of its own. Its sets are those of the whole diagram, in the same
/// order.
struct Enlargement {
  PhaseDiagram diagram;
  PhaseRegions regions;
};

struct ThinRegions {
  std::vector<ThinRegion> regions;  ///< by set
  std::vector<Enlargement> enlargements;
};

/// The thickness of a set where it is thickest inside a frame, horizontally and vertically, in pixels; nothing if it is
/// not in the frame.
std::optional<double> thickness(const PhaseRegions& regions, const MotionSet& set, const Frame& frame);

/// The sets that are thinner than least_seen everywhere in the frame, and a few enlargements for the thickest of them.
/// Sets that only the enlargements show are added to the sets of `regions`. Enlargements have a frame of the size of
/// `small`.
ThinRegions thin_regions(const PhaseDiagram& diagram, PhaseRegions& regions, const Frame& frame, const Frame& small);

}  // namespace slipproof
