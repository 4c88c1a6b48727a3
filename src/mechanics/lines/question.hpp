// What decides an answer at one point of a family: conditions, modes, and what they are compared with.
#pragma once

#include <optional>
#include <vector>

#include "mechanics/family/compiled_family.hpp"

namespace slipproof {

struct Question {
  std::vector<const Program*> conditions;  ///< truths over parameters, definitions and the force
  std::vector<const Program*> of_motions;  ///< truths over the quantities of each mode's motion, too
  std::vector<MechanismMode> modes;        ///< the modes whose motions decide
  bool modes_meet = false;                 ///< the forces of one mode are compared with those of another
  std::optional<std::size_t> grows;        ///< for a limit: the parameter that goes to the end of its domain
};

}  // namespace slipproof
