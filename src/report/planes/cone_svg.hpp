// Contacts in their friction cones as SVG.
#pragma once

#include <string>

#include "report/markup/element.hpp"
#include "report/planes/cone_disc.hpp"

namespace slipproof {

/// Adds the picture as a last child, in dimension 2 and 3; needs picture_style() in the document. Its title and
/// description have the ids ID-title and ID-text. data-plot gives the place of (0, 0) and the length of a unit: x, y,
/// length. Planar contacts are one below the other, by number.
Element add_cone_disc(const Element& parent, const ConeDisc& disc, const std::string& id);

/// Whether a point is drawn at the edge of the picture because its place is farther out.
bool is_beyond(const ConeDisc& disc, const ConePoint& point);

}  // namespace slipproof
