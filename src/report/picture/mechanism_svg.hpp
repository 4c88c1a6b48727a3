// A mechanism drawn from the shapes in its file, with the forces of a motion as arrows.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mechanics/kernel/motion.hpp"
#include "mechanics/scene/scene.hpp"
#include "report/markup/element.hpp"
#include "report/picture/frame/picture_frame.hpp"
#include "report/picture/motion_words.hpp"

namespace slipproof {

/// Whether a mechanism's file gives a place for any part: a shape, or a contact with `at`.
bool has_picture(const Mechanism& mechanism);

/// What pictures of several motions share.
struct CommonLook {
  std::optional<NumberWords> numbers;  ///< nothing: those of the picture's own motion
  double largest_force = 0;            ///< the one with the longest arrow; 0: the largest of the picture
  bool brief = false;                  ///< leaves out what is listed below the drawing
  bool is_virtual = false;             ///< velocities are those of a virtual motion, and dotted
  double share = 1;                    ///< of the usual room for few contacts; less: larger letters
  bool movable = false;                ///< each part says how it moves, where all parts are those of bodies
  bool animated = false;               ///< outlines go on for half a second of the motion's accelerations
};

/// The largest force of a motion that has an arrow.
double largest_force(const MechanismScene& scene, const MotionAtLoad& motion);

/// How high the picture of a mechanism should be: as usual, or higher where a table of its contacts is below it.
double picture_height(const MechanismScene& scene, double usual);

/// Adds the mechanism of a scene, to scale, y up, with a mark at each contact; turned so that gravity points down. The
/// forces of `motion`, which must be one of motions_of() its problem, act at the contacts; pushes, weights and
/// velocities are those of a scene of bodies. Arrows of forces are to scale: N acts from outside on the body that it
/// pushes, S along positive slip. A force that is undetermined is dashed, at the middle of its range. Where a contact
/// opens, its surface is apart from the body. Without a motion all arrows have the same length and point in the
/// positive directions. From eight contacts on, letters name them and a table below says the rest. Forces and contacts
/// without a place are listed below the drawing. Everything is inside the viewBox. Needs picture_style() in the
/// document. Throws InputError if the mechanism has no picture, or if a coordinate has no value.
/// `seen` becomes the box of its viewBox. A part that can move has data-about, a place in pixels; data-velocity and
/// data-acceleration, of this place to the right and down, and of its turn, clockwise, in pixels, radians and seconds.
/// A line between two bodies has all of them twice, for either end.
/// The surface of a contact that opens has data-opens, how far it is drawn apart.
Element add_mechanism(const Element& parent, const MechanismScene& scene, const MotionAtLoad* motion,
                      std::string_view title, const CommonLook& look = {}, LabelBox* seen = nullptr);

/// The same as an SVG file of its own, with a title, and with a background for light and dark displays. Below the title
/// stands the heading; if it is empty, the modes of the motion.
std::string mechanism_svg_file(const MechanismScene& scene, const MotionAtLoad* motion, const CommonLook& look = {},
                               const std::string& heading = {});

}  // namespace slipproof
