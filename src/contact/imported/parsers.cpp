// The door of the module.
#include "contact/imported/parsers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "contact/imported/readers.hpp"

namespace slipproof::imported {

Turn turn_of(const std::array<double, 4>& quaternion, const std::string& whose, Scene& scene) {
  const RationalTurn found = rational_turn(quaternion);
  if (found.error > 0) {
    const std::string sentence =
        fmt::format("{}: its turn is not rational; one that is {:.1g} rad away is taken", whose, found.error);
    if (std::ranges::find(scene.import_notes, sentence) == scene.import_notes.end())
      scene.import_notes.push_back(sentence);
  }
  return found.turn;
}

void note_limits(const Joint& joint, bool are_far, Scene& scene) {
  if (are_far)
    return scene.import_notes.push_back(joint.name + ": its limits, which are not reached here, are left out");
  scene.only_in_space.push_back(
      {joint.place, joint.name + ": found it at a limit, or beyond: a stop is not read",
       joint.name + ": it is at a limit, or beyond; the stop is left out, and does not hold it"});
}

}  // namespace slipproof::imported

extern "C" __attribute__((visibility("default"))) void slipproof_parse_scene(
    slipproof::imported::TaggedFile* file, const slipproof::imported::ReadOptions* options,
    slipproof::imported::Scene* scene, slipproof::Mistakes* mistakes) {
  using namespace slipproof::imported;
  const std::string_view root = file->root().name();
  try {
    if (root == "robot") read_urdf(*file, *options, *scene, *mistakes);
    if (root == "sdf") read_sdf(*file, *options, *scene, *mistakes);
    if (root == "mujoco") read_mjcf(*file, *options, *scene, *mistakes);
  } catch (const std::exception& error) {  // its type is another one beyond this door
    mistakes->add(file->place(file->root()), error.what());
  }
}
