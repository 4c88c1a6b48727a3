// A mechanism as its file's shapes draw it, with the forces of a motion as arrows.
#pragma once

#include <string>
#include <string_view>

#include "mechanics/kernel/motions.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/markup/element.hpp"

namespace slipproof {

/// Whether a mechanism says where anything of it is: a shape, or a contact with `at`.
bool has_picture(const Mechanism& mechanism);

/// The mechanism of a scene, to scale, y up, with a mark at each contact. The forces of `motion`, which are
/// motions_of() its problem, act at the contacts as arrows in proportion to each other, none shorter than can be seen:
/// N from outside against the body that it pushes, S along positive slip. A force that is undetermined is dashed, at
/// the middle of its range. Without a motion all arrows have one length, and point where a force counts as positive.
/// Forces that have no place, and contacts without one, are told below. Everything is inside of the viewBox. Needs
/// picture_style() in the document. Throws InputError where there is no picture, or a coordinate has no value.
Element add_mechanism(const Element& parent, const MechanismScene& scene, const MotionAtLoad* motion,
                      std::string_view title);

/// The same as a file of its own, SVG, with a title, on a ground of its own in light and dark.
std::string mechanism_svg_file(const MechanismScene& scene, const MotionAtLoad* motion);

}  // namespace slipproof
