// A scene in space whose bodies stand in a text, solved.
#pragma once

#include <string>

#include "contact/space/solve_space.hpp"

namespace slipproof::test {

/// A contact with the surface z = 0 of a body, or of the ground.
inline std::string standing(const std::string& name, const std::string& of, const std::string& point,
                            const std::string& friction, const std::string& on = "ground") {
  return "[[contact]]\nname = \"" + name + "\"\nof = \"" + of + "\"\non = \"" + on + "\"\npoint = [" + point +
         R"(]
normal = ["0", "0", "1"]
through = ["0", "0", "0"]
friction = ")" +
         friction + "\"\n";
}

/// All in numbers; gravity is 10, along -z.
inline SolvedSpace solved_text(const std::string& bodies) {
  const std::string top = "schema = \"slipproof/mechanism/1\"\nname = \"a scene in space\"\ndimension = 3\n";
  return solve_space(parse_scene(top + "gravity = [\"0\", \"0\", \"-10\"]\n" + bodies, "in space", Dimensions::any));
}

}  // namespace slipproof::test
