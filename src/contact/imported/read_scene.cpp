#include "contact/imported/read_scene.hpp"

#include <fmt/format.h>

#include "base/input/text_file.hpp"
#include "base/number/parse.hpp"

namespace slipproof::imported {

namespace {

constexpr std::size_t max_scene_size = std::size_t{16} << 20U;

}  // namespace

Turn turn_of(const std::array<double, 4>& quaternion, const std::string& whose, Scene& scene) {
  const RationalTurn found = rational_turn(quaternion);
  if (found.error > 0) {
    scene.told.push_back(
        fmt::format("{}: its turn is not rational; one that is {:.1g} rad away is taken", whose, found.error));
  }
  return found.turn;
}

Scene parse_scene_of_bodies(std::string text, const std::string& file) {
  TaggedFile tagged(std::move(text), file);
  Mistakes mistakes(file);
  Scene scene;
  scene.file = file;
  const std::string root = tagged.root().name();
  const Place beginning = tagged.place(tagged.root());
  try {
    if (root == "robot") {
      read_urdf(tagged, scene, mistakes);
    } else if (root == "sdf") {
      read_sdf(tagged, scene, mistakes);
    } else if (root == "mujoco") {
      read_mjcf(tagged, scene, mistakes);
    } else {
      mistakes.add(beginning, "found <" + root + ">, expected <robot> (URDF), <sdf> or <mujoco> (MJCF)");
    }
  } catch (const NumberError& error) {
    mistakes.add(beginning, error.what());
  }
  mistakes.refuse_if_any();
  join_fixed(scene, mistakes);
  mistakes.refuse_if_any();
  return scene;
}

Scene read_scene_of_bodies(const std::filesystem::path& file) {
  return parse_scene_of_bodies(read_text_file(file, max_scene_size), file.string());
}

}  // namespace slipproof::imported
