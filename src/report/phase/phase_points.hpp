// Exact sample points of a phase diagram, shown when the reader points at them.
#pragma once

#include <string>
#include <vector>

#include "mechanics/planes/phase_diagram.hpp"

namespace slipproof {

/// A point and the motions there.
struct PhasePoint {
  struct Motion {
    std::vector<MechanismMode> modes;             ///< all of them
    bool strict = false;                          ///< the motion is strict in one of these modes
    std::vector<std::optional<Rational>> values;  ///< values of the plane's quantities; nothing if one is undetermined
  };
  Rational x, y;
  std::vector<Motion> motions;
  std::vector<MechanismMode> continua;
};

/// About `across` times `up` points, on the diagram's evenly spaced columns, without points outside the domain.
std::vector<PhasePoint> sample_points(const PhaseDiagram& diagram, std::size_t across, std::size_t up);

/// The points of a diagram as JSON for a script: exact numbers are strings; there is no `<` and no `&`. What occurs
/// often is listed once: `xs` and `ys`, each a share of the axis and the number, `modes`, each the names of a motion's
/// modes and whether it is strict, and the `names` of the quantities. A point is the indices of its x and y, its
/// motions, each the index of its modes and the values of the quantities (0 if zero, null if undetermined), and its
/// continua.
std::string points_json(const PhaseDiagram& diagram, const std::vector<PhasePoint>& points);

}  // namespace slipproof
