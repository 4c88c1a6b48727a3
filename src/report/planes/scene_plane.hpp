// The plane of one parameter of a scene and the force.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/bicycle/scene.hpp"
#include "report/phase/phase_diagram.hpp"

namespace slipproof {

/// What may vary: the keys of a scene file that are numbers, without the force.
std::vector<std::string_view> scene_parameters();

/// The value of a parameter in a scene, by its key in a scene file (`f`, `b`, `h0`, ...); nothing for another name, and
/// for J where the scene has none.
std::optional<Rational> scene_parameter(const Scene& scene, std::string_view parameter);

/// The scene with another value; nothing where that is out of the parameter's domain. `b` sets b2 and b3.
std::optional<Scene> with_parameter(const Scene& scene, std::string_view parameter, const Rational& value);

/// What a plane of a scene is asked for; what is left open is chosen so that the scene's thresholds are inside.
struct SceneAxes {
  std::string x = "f";
  std::optional<Rational> x_from, x_to, y_from, y_to;
};

/// Throws std::invalid_argument, with a message for people, for a parameter that does not exist or an empty range.
Plane scene_plane(const Scene& scene, const SceneAxes& axes, std::string id);

}  // namespace slipproof
