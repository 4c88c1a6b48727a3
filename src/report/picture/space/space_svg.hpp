// A scene in space drawn from the shapes of its bodies, in parallel projection, with the forces of its motions as
// arrows.
#pragma once

#include <string>

#include "contact/space/solved_space.hpp"
#include "report/picture/space/vectors.hpp"

namespace slipproof {

/// An SVG file, seen from a direction (view_direction()), with up against gravity. Solids hide what is behind them, and
/// throw shadows straight down onto the planes that they touch. The force of a contact begins there, in its friction
/// cone, whose circle is as high as N and mu times as wide; forces of one file are to scale. A force that is not known
/// narrowly is dashed, at the middle of its range. Where a contact slips, an arrow in its plane shows the direction,
/// and a sector all directions of its enclosure. Velocities are thin, accelerations dotted. A table says the numbers.
/// Without a motion, arrows show the positive directions of N, T1 and T2. Throws InputError if a coordinate has no
/// value, or nothing has a place.
std::string space_svg_file(const MechanismScene& scene, const Vec3& from);
/// The same with a motion of the scene's; under a heading, or under its mode.
std::string space_svg_file(const SolvedSpace& solved, std::size_t motion, const Vec3& from,
                           const std::string& heading = {});
/// A virtual motion: its rates in place of accelerations, without units, and no forces of contacts.
std::string virtual_motion_svg_file(const MechanismScene& scene, const SpaceMotion& rates, const Vec3& from,
                                    const std::string& heading);

/// All motions side by side, each with what it is: its mode, one of a continuum, forces open.
std::string space_motions_svg_file(const SolvedSpace& solved, const Vec3& from);

/// The same pictures as numbers in space, for a page that turns them: solids, joints, and of each motion the lines of
/// its arrows, its labels and its table.
std::string space_model_json(const SolvedSpace& solved);

}  // namespace slipproof
