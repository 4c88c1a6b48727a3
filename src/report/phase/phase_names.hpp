// Names inside of a phase diagram, where there is room for them.
#pragma once

#include "report/markup/element.hpp"
#include "report/phase/axis.hpp"
#include "report/phase/phase_regions.hpp"

namespace slipproof {

/// Of the regions: at the roomiest place of each, if it fits there.
void add_region_names(const Element& plot, const PhaseRegions& regions, const Frame& frame);

/// Of each curve, at the middle of the longest piece where it is a border; of one that nowhere is, where it can be
/// seen.
void add_curve_names(const Element& plot, const Plane& plane, const PhaseRegions& regions, const Frame& frame);

/// Of upright lines, at the top; of two that are too close, the second one is lower.
void add_line_names(const Element& plot, const Plane& plane, const Frame& frame);

}  // namespace slipproof
