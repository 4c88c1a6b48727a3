#include "report/expected/expected.hpp"

#include <stdexcept>
#include <utility>

#include "base/input/diagnostic.hpp"

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
  return {id, SolvedMechanism(std::move(scene), true, Listing::motions), std::move(changes)};
}

}  // namespace slipproof
