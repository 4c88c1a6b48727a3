#include "contact/exchange/touch.hpp"

#include <numeric>

#include "base/number/format.hpp"

namespace slipproof::imported {

void complete(Scene& scene, const TouchOptions& options) {
  if (options.gravity) {
    scene.gravity = Vector{0, 0, -*options.gravity};
  } else if (!scene.gravity) {
    scene.gravity = Vector{0, 0, Rational(-981, 100)};
    scene.import_notes.push_back(scene.format + " has no gravity: 9.81 along -z is taken (--gravity says another)");
  }
  if (!options.ground) return;
  Shape plane;
  plane.kind = Shape::Kind::plane;
  plane.name = "ground";
  plane.pose.at.z = *options.ground;
  plane.kinds = plane.meets = ~0U;
  scene.bodies[0].shapes.push_back(std::move(plane));
}

Rational friction_at(const Scene& scene, const Shape& a, const Shape& b, const TouchOptions& options,
                     Mistakes& mistakes) {
  const auto mu = friction_between(scene, a, b, options.mu);
  if (!mu) {
    mistakes.add(b.place, b.name + " touches " + a.name +
                              ", and nothing says with which one coefficient of friction: --mu does");
    return 0;
  }
  if (mu->sign() < 0) mistakes.add(b.place, b.name + ": found a negative coefficient of friction");
  return *mu;
}

std::vector<std::size_t> trees_of(const Scene& scene) {
  std::vector<std::size_t> tree(scene.bodies.size());
  std::iota(tree.begin(), tree.end(), std::size_t{0});
  for (bool changed = true; changed;) {
    changed = false;
    for (const Joint& joint : scene.joints) {
      if (joint.first == 0 || joint.second == 0) continue;
      const std::size_t least = std::min(tree[joint.first], tree[joint.second]);
      changed = changed || tree[joint.first] != least || tree[joint.second] != least;
      tree[joint.first] = tree[joint.second] = least;
    }
  }
  return tree;
}

std::string distance_in_words(const Rational& distance) {
  return decimal_text(abs(distance), 2) + (distance.sign() < 0 ? " inside each other" : " apart");
}

}  // namespace slipproof::imported
