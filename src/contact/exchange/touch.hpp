// What both ways of reading a scene, in a plane and in space, ask of it.
#pragma once

#include <optional>
#include <string>

#include "contact/imported/scene.hpp"

namespace slipproof::imported {

struct TouchOptions {
  Rational touch = Rational(1, 10000);  ///< shapes that are at most so far apart, or inside each other, touch
  std::optional<Rational> mu;           ///< for all contacts, instead of the file's
  std::optional<Rational> ground;       ///< a level plane at this height
  std::optional<Rational> gravity;      ///< along -z, instead of the file's
};

/// Adds the requested ground and gravity. URDF has no gravity, so 9.81 is assumed and noted.
void complete(Scene& scene, const TouchOptions& options);

/// The coefficient of two shapes that touch; a mistake where nothing says one.
Rational friction_at(const Scene& scene, const Shape& a, const Shape& b, const TouchOptions& options,
                     Mistakes& mistakes);

/// Calls each(body, shape, other body, other shape) for the pairs of shapes that may touch: of two bodies that no joint
/// connects and that are not both fixed.
template <class Each>
void for_each_pair(const Scene& scene, const Each& each) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < scene.bodies.size(); ++j) {
      if (are_joined(scene, i, j)) continue;
      for (const Shape& a : scene.bodies[i].shapes) {
        for (const Shape& b : scene.bodies[j].shapes) {
          if (may_touch(a, b)) each(i, a, j, b);
        }
      }
    }
  }
}

/// The first body of the tree of joints that each body belongs to; the ground belongs to none.
std::vector<std::size_t> trees_of(const Scene& scene);

/// `0.00002 apart`, `0.00002 inside each other`.
std::string distance_in_words(const Rational& distance);

}  // namespace slipproof::imported
