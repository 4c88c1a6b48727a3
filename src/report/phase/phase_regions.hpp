// Makes the shapes of a phase diagram from its columns, in the units of its axes and rounded to binary64.
#pragma once

#include <optional>
#include <vector>

#include "mechanics/planes/phase_diagram.hpp"

namespace slipproof {

struct PlanePoint {
  double x, y;
};

/// One cell, followed through neighbouring columns.
struct Strip {
  MotionSet set;
  /// From left to right, at the same x; one point: the cell is in that column only.
  std::vector<PlanePoint> lower, upper;
};

/// A line that separates two strips; or a part of a curve of the plane where nothing changes.
struct PhaseLine {
  enum class Kind {
    edge,   ///< the motions change here, on a curve of the plane; or the plane has no curves
    extra,  ///< the motions change here, but there is no curve
    idle    ///< a curve at which the motions do not change
  };
  Kind kind = Kind::edge;
  std::optional<std::size_t> curve;
  std::vector<PlanePoint> points;
};

/// Loads at which a claim is false, followed through neighbouring columns.
struct RefutedStrip {
  std::size_t claim = 0;  ///< index in the plane's claims
  std::vector<PlanePoint> lower, upper;
};

struct PhaseRegions {
  std::vector<Strip> strips;
  std::vector<PhaseLine> lines;
  std::vector<RefutedStrip> refuted;

  /// The sets of motions inside the picture, however thin, from bottom to top, each once.
  std::vector<MotionSet> sets;
  /// For a plane that searches for its domain: whether the domain ends inside the picture.
  bool leaves_domain = false;
};

PhaseRegions phase_regions(const PhaseDiagram& diagram);

}  // namespace slipproof
