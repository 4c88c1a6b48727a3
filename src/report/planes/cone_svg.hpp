// Contacts in their friction cones as SVG.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "report/markup/element.hpp"
#include "report/planes/cone_disc.hpp"

namespace slipproof {

/// The picture as a last child, in dimension 2 and 3; needs picture_style() in the document. Its title and description
/// have the ids ID-title and ID-text. data-plot tells where (0, 0) is and how long a unit is across: x, y, length; in
/// the plane contacts stand below each other in the order of their numbers.
Element add_cone_disc(const Element& parent, const ConeDisc& disc, const std::string& id);

/// Whether a point stands at the picture's edge, because its place is farther out.
bool is_beyond(const ConeDisc& disc, const ConePoint& point);

enum class ConeSign : std::uint8_t { open, stick, slide, smooth, marked, law, pyramid };

/// What a sign of the picture, or of counts, looks like, 28 x 18.
Element add_swatch(const Element& parent, ConeSign sign);

/// `fit-open`, ...: the class of its colour; only for the four ways of obeying the law.
std::string_view fill_class(ConeSign sign);

}  // namespace slipproof
