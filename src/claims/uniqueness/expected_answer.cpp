#include "claims/uniqueness/expected_answer.hpp"

#include <stdexcept>
#include <utility>

#include "base/input/diagnostic.hpp"
#include "contact/problem/every_push.hpp"
#include "mechanics/scene/solve_mechanism.hpp"

namespace slipproof {

ExpectedAnswer expected_answer(MechanismScene scene, const std::string& id) {
  const Mechanism& m = scene.mechanism;
  if (m.load && !scene.load) {
    throw InputError(
        {{m.file, 0, 0,
          id + ": found no value of the load " + m.load->symbol + ", expected one: an engine answers at one load"}});
  }
  std::vector<MotionChange> changes;
  if (const auto& threshold = scene.threshold) {
    try {
      changes = motion_changes(scene, threshold->parameter, threshold->from, threshold->to);
    } catch (const std::invalid_argument& error) {
      throw InputError({{m.file, 0, 0, id + ": [threshold]: " + error.what()}});
    }
  }
  SolvedMechanism solved = solve_mechanism(std::move(scene), Listing::motions);
  auto every_q = for_every_push(solved.problem);
  return {id, std::move(solved), std::move(every_q), std::move(changes)};
}

}  // namespace slipproof
