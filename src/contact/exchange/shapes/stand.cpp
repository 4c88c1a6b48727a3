#include "contact/exchange/shapes/stand.hpp"

#include <algorithm>

#include "base/number/format.hpp"
#include "contact/exchange/shapes/pairs.hpp"
#include "contact/exchange/touch.hpp"

namespace slipproof::imported {

namespace {

/// How far a shape is above a plane, measured along z; nothing where they cannot touch.
std::optional<Rational> height(const Shape& shape, const Shape& plane) {
  const Vector& normal = plane.pose.turn.axes[2];
  if (plane.kind != Shape::Kind::plane || normal.z.sign() <= 0 || !may_touch(shape, plane)) return std::nullopt;
  const auto least = least_along(shape, normal);
  if (!least) return std::nullopt;
  return (*least - dot(plane.pose.at, normal)) / normal.z;
}

}  // namespace

void stand_on_ground(Scene& scene) {
  const std::vector<std::size_t> tree = trees_of(scene);
  for (std::size_t first = 1; first < scene.bodies.size(); ++first) {
    std::vector<bool> own(scene.bodies.size());
    for (std::size_t i = 1; i < own.size(); ++i) own[i] = tree[i] == first;
    const auto to_ground = [&](const Joint& joint) {
      return (joint.first == 0 && own[joint.second]) || (joint.second == 0 && own[joint.first]);
    };
    if (!own[first] || std::ranges::any_of(scene.joints, to_ground)) continue;
    std::optional<Rational> least;
    for (std::size_t i = first; i < own.size(); ++i) {
      if (!own[i]) continue;
      for (const Shape& shape : scene.bodies[i].shapes) {
        for (const Shape& plane : scene.bodies[0].shapes) {
          const auto here = height(shape, plane);
          if (here && (!least || *here < *least)) least = here;
        }
      }
    }
    if (!least || least->is_zero()) continue;
    move(scene, own, {0, 0, -*least});
    scene.import_notes.push_back(scene.bodies[first].name + " and what it carries: moved " +
                                 (least->sign() > 0 ? "down" : "up") + " by " + decimal_text(abs(*least), 2) +
                                 " to stand on the ground");
  }
}

}  // namespace slipproof::imported
