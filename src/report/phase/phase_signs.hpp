// The signs in a phase diagram beside the colours of its sets: what a legend says of them.
#pragma once

#include <string>
#include <vector>

#include "report/markup/element.hpp"
#include "report/phase/phase_svg.hpp"

namespace slipproof {

struct PhaseSign {
  enum class Kind { mark, place, line, dots, stripes, hatching };
  Kind kind = Kind::mark;
  std::string words;
};

/// Those that occur in the picture: the plane's mark, lines where the motions change (in a plane without curves, which
/// say more), the dots of an open contact, the stripes of several motions.
std::vector<PhaseSign> phase_signs(const PhasePicture& picture);

/// Draws the sign, 28 x 18, for a legend.
void draw_sign(const Element& parent, const PhasePicture& picture, const PhaseSign& sign);

}  // namespace slipproof
