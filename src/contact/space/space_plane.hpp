// The plane of the load and a parameter in a scene in space, and the line of a parameter: all motions at single places.
#pragma once

#include "base/number/effort.hpp"
#include "contact/space/solved_space.hpp"
#include "mechanics/planes/mechanism_plane.hpp"
#include "mechanics/planes/sets_along.hpp"

namespace slipproof {

inline constexpr Work effort_of_a_place = 2'000'000'000;  ///< about two seconds

/// The motions of a solved scene by their modes; complete if all of them are known and exist.
MotionSet motion_set(const SolvedSpace& solved);

/// The plane of a scene in space, for raster_diagram(). A search of a place that takes more than `effort` is given up,
/// and its motions are not complete. Throws std::invalid_argument as plane_frame() does, and InputError as
/// solve_space() does at the scene's own values.
Plane space_plane(const MechanismScene& scene, const MechanismAxes& axes, std::string id, Work effort);

/// At the scene's load, along axes.x, in so many parts. Throws the same.
SetsAlong space_along(const MechanismScene& scene, const MechanismAxes& axes, std::size_t parts, Work effort,
                      const std::function<void(std::uint64_t done, std::uint64_t all)>& progress);

}  // namespace slipproof
