// The shapes of a phase diagram, from its columns: what is drawn, in the units of its axes and rounded to binary64.
#pragma once

#include <optional>
#include <vector>

#include "report/phase/phase_diagram.hpp"

namespace slipproof {

struct PlanePoint {
  double x, y;
};

/// One cell followed through neighbouring columns.
struct Strip {
  MotionSet set;
  std::vector<PlanePoint> lower, upper;  ///< from left to right, at the same x; one point: only in that column
};

/// What separates two strips; or where one of the plane's curves is and nothing changes.
struct PhaseLine {
  enum class Kind {
    edge,   ///< the motions change here: on a curve of the plane, or the plane has none
    extra,  ///< the motions change here, exactly where no curve is
    idle    ///< a curve, and the motions do not change
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

  /// The sets of motions inside of the picture, however thin, from the bottom to the top, each once.
  std::vector<MotionSet> sets;
  /// Of a plane that finds its domain: whether the domain ends inside of the picture.
  bool leaves_domain = false;
};

PhaseRegions phase_regions(const PhaseDiagram& diagram);

}  // namespace slipproof
