// The plane of a parameter or an angle of a mechanism's scene, and the load.
#pragma once

#include <optional>
#include <string>

#include "mechanics/scene/scene.hpp"
#include "report/phase/phase_diagram.hpp"

namespace slipproof {

/// What a plane of a mechanism is asked for; what is left open is chosen from the scene and the domain.
struct MechanismAxes {
  std::string x;  ///< a parameter, an angle, or a combined parameter; empty: the first coefficient of friction
  std::optional<Rational> x_from, x_to;  ///< of an angle: in degrees, between -180 and 180
  std::optional<Rational> y_from, y_to;  ///< of the load
};

/// The plane of a scene. Each column is a point of the domain: where an equation of the domain or of [assume] ties x to
/// other parameters, the last of these follows, and the plane's note says so; other values of x are left out. An angle
/// goes by tan(angle/2). Throws InputError for more modes than are tried, before any work; std::invalid_argument, with
/// a message for people, for a mechanism without a load, an x that the scene does not have, an empty range, or one in
/// which x has no values side by side in the domain.
Plane mechanism_plane(const MechanismScene& scene, const MechanismAxes& axes, std::string id);

/// One JSON document, schema slipproof/map/2: every column with its exact intervals of the load.
std::string map_json(const PhaseDiagram& diagram, const MechanismScene& scene);

}  // namespace slipproof
