// Regions of a phase diagram that are too thin to be seen, and enlargements in which they can be.
#pragma once

#include <optional>
#include <vector>

#include "report/phase/axis.hpp"
#include "report/phase/phase_regions.hpp"

namespace slipproof {

/// What is thinner is drawn as wide as this, in pixels.
inline constexpr double least_seen = 4;

struct ThinRegion {
  std::size_t set = 0;  ///< of the regions' sets
  PlanePoint at;        ///< where it is thickest
  bool line = false;    ///< it is only in single columns, and no enlargement makes it wider
  std::optional<std::size_t> enlargement;
};

/// A part of a diagram, solved again in columns of its own. Its sets are those of the whole, in the same order.
struct Enlargement {
  PhaseDiagram diagram;
  PhaseRegions regions;
};

struct ThinRegions {
  std::vector<ThinRegion> regions;  ///< by set
  std::vector<Enlargement> enlargements;
};

/// How thick a set is at its thickest inside of a frame, across and up, in pixels; nothing where it is not in it.
std::optional<double> thickness(const PhaseRegions& regions, const MotionSet& set, const Frame& frame);

/// Sets that are nowhere as thick as least_seen in the frame, and for the thickest of them a few enlargements. Sets
/// that only these show are added to the regions'. An enlargement is for a frame of the size of `small`.
ThinRegions thin_regions(const PhaseDiagram& diagram, PhaseRegions& regions, const Frame& frame, const Frame& small);

}  // namespace slipproof
