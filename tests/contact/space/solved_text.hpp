// A scene in space whose bodies stand in a text, solved.
#pragma once

#include <string>

#include "contact/space/solve_space.hpp"

namespace slipproof::test {

/// All in numbers; gravity is 10, along -z.
inline SolvedSpace solved_text(const std::string& bodies) {
  const std::string top = "schema = \"slipproof/mechanism/1\"\nname = \"a scene in space\"\ndimension = 3\n";
  return solve_space(parse_scene(top + "gravity = [\"0\", \"0\", \"-10\"]\n" + bodies, "in space", Dimensions::any));
}

}  // namespace slipproof::test
