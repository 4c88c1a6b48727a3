// The one motion of a scene in space, by the names of its accelerations and forces.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "contact/space/solved_space.hpp"

namespace slipproof::test {

inline Range value(const SolvedSpace& solved, const std::string& name) {
  REQUIRE(solved.complete());
  REQUIRE(solved.motions.size() == 1);
  const Mechanism& m = solved.scene.mechanism;
  const SpaceMotion& motion = solved.motions.front();
  const auto accelerations = acceleration_names(m), forces = force_names(m);
  const auto a = std::ranges::find(accelerations, name), f = std::ranges::find(forces, name);
  if (a != accelerations.end()) return motion.accelerations[static_cast<std::size_t>(a - accelerations.begin())];
  REQUIRE_MESSAGE(f != forces.end(), name);
  return motion.forces[static_cast<std::size_t>(f - forces.begin())].value();
}
inline bool is(const SolvedSpace& solved, const std::string& name, const Rational& expected) {
  const Range range = value(solved, name);
  return range.is_point() && *range.lower == expected;
}
inline bool contains(const SolvedSpace& solved, const std::string& name, const Rational& expected) {
  const Range range = value(solved, name);
  return *range.lower <= expected && expected <= *range.upper && *range.upper - *range.lower < Rational(1, 1'000'000);
}

}  // namespace slipproof::test
