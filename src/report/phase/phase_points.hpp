// Exact sample points of a phase diagram, shown when the reader points at them.
#pragma once

#include <string>
#include <vector>

#include "report/phase/phase_diagram.hpp"

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

/// The points of a diagram as JSON for a script: exact numbers are strings; there is no `<` and no `&`.
std::string points_json(const PhaseDiagram& diagram, const std::vector<PhasePoint>& points);

}  // namespace slipproof
