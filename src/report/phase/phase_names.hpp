// Names in a phase diagram, where there is room for them.
#pragma once

#include "report/markup/element.hpp"
#include "report/phase/axis.hpp"
#include "report/phase/phase_regions.hpp"

namespace slipproof {

/// Adds the names of regions, each at its roomiest place if it fits there.
void add_region_names(const Element& plot, const PhaseRegions& regions, const Frame& frame);

/// Adds the names of curves, each at the middle of its longest piece that is a border; if it has none, at a place where
/// it can be seen.
void add_curve_names(const Element& plot, const Plane& plane, const PhaseRegions& regions, const Frame& frame);

/// Adds the names of vertical lines, at the top; if two are too close, the second is lower.
void add_line_names(const Element& plot, const Plane& plane, const Frame& frame);

}  // namespace slipproof
