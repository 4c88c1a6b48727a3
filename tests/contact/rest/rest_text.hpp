// A scene whose bodies stand in a text, and whether it rests.
#pragma once

#include <string>

#include "contact/rest/rest.hpp"

namespace slipproof::test {

/// In the plane: gravity is 10, along -y. `top` has parameters, angles or a load.
inline MechanismScene plane_scene(const std::string& bodies, const std::string& top = "gravity = [\"0\", \"-10\"]\n") {
  return parse_scene("schema = \"slipproof/mechanism/1\"\nname = \"a scene\"\n" + top + bodies, "in the plane",
                     Dimensions::any);
}

/// In space: gravity is 10, along -z.
inline MechanismScene space_scene(const std::string& bodies,
                                  const std::string& gravity = "gravity = [\"0\", \"0\", \"-10\"]\n") {
  return parse_scene("schema = \"slipproof/mechanism/1\"\nname = \"a scene\"\ndimension = 3\n" + gravity + bodies,
                     "in space", Dimensions::any);
}

inline Rational force(const RestAnswer& answer, const std::string& name) {
  for (std::size_t i = 0; i < answer.problem.forces.size(); ++i) {
    if (answer.problem.forces[i] == name) return answer.decision.forces.at(i);
  }
  throw std::out_of_range(name);
}

}  // namespace slipproof::test
