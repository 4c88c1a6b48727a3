// What proves that a scene can rest, or cannot, drawn.
#pragma once

#include <string>

#include "contact/rest/rest_answer.hpp"
#include "report/picture/space/vectors.hpp"

namespace slipproof {

/// An SVG file: the forces that hold the scene, to scale as those of a motion, or the virtual motion that proves its
/// fall, dotted. `from` is where one looks from in space. Throws InputError if nothing is proved, if the mechanism's
/// equations are given as printed, whose rows are no motions, or if there is no picture.
std::string rest_svg_file(const RestAnswer& answer, const Vec3& from);

}  // namespace slipproof
