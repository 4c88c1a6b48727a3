// The map of two loads at which a scene can rest, as SVG.
#pragma once

#include <string>

#include "contact/rest/rest_answer.hpp"

namespace slipproof {

/// An SVG file of the answer's map: where it can rest, with dots at the corners at which forces are known; what borders
/// leave open; the borders, numbered, with the contacts that move in their virtual motions; the scene's own values.
std::string rest_map_svg_file(const RestAnswer& answer);

}  // namespace slipproof
