// The plane of the load and a parameter or an angle in a mechanism's scene.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "mechanics/planes/phase_diagram.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

class FreedScene;

/// The requested axes of a plane. What is not given is chosen from the scene and the domain.
struct MechanismAxes {
  std::string x;  ///< a parameter, an angle, or a combined parameter; empty: the first coefficient of friction
  std::optional<Rational> x_from, x_to;  ///< for an angle: in degrees, between -180 and 180
  std::optional<Rational> y_from, y_to;  ///< of the load
};

/// The scene with the axis of a plane freed.
std::shared_ptr<const FreedScene> freed_for(const MechanismScene& scene, const MechanismAxes& axes);
/// Axes, title and words of the plane of a scene, in the plane or in space, without what solves it. Throws
/// std::invalid_argument as mechanism_plane() does.
Plane plane_frame(const MechanismScene& scene, const FreedScene& freed, const MechanismAxes& axes, std::string id);

/// The plane of a scene in the plane. Each column is a point of the domain. If an equation of the domain or of [assume]
/// ties x to other parameters, the last of these follows x, and the plane's note says so; other values of x are left
/// out. An angle is represented by tan(angle/2). Before any work, throws InputError if there are more modes than are
/// tried; throws std::invalid_argument, with a message for people, for a mechanism without a load, for an x that the
/// scene does not have, for an empty range, and for a range in which x has no neighbouring values in the domain.
Plane mechanism_plane(const MechanismScene& scene, const MechanismAxes& axes, std::string id);

}  // namespace slipproof
