// A page on which a scene in space is turned by hand.
#pragma once

#include <string>

#include "contact/space/solved_space.hpp"

namespace slipproof {

/// One HTML file that holds all motions of a scene, drawn as space_svg_file() draws them, from any direction.
std::string space_page(const SolvedSpace& solved);

}  // namespace slipproof
