#include "report/explorer/portable_scene.hpp"

#include <filesystem>
#include <optional>
#include <utility>

#include "base/input/diagnostic.hpp"
#include "base/input/text_file.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/reading/shipped.hpp"
#include "mechanics/reading/write_mechanism.hpp"

namespace slipproof {

namespace {

/// The text and mechanism of a file by bodies, which the equations do not say; nothing if there is no such file any
/// more, or if it is a scene with its mechanism.
std::optional<std::pair<std::string, Mechanism>> file_by_bodies(const Mechanism& mechanism) {
  if (!mechanism.bodies) return std::nullopt;
  try {
    std::string text = read_text_file(mechanism.file);
    Mechanism read = parse_mechanism(text, mechanism.file);
    return std::pair(std::move(text), std::move(read));
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

PortableScene portable(const MechanismScene& scene) {
  const Mechanism& mechanism = scene.mechanism;
  PortableScene result;
  result.mechanism = "mechanism.toml";
  std::optional<MechanismLoad> own = mechanism.load;  // of the file
  if (mechanism.shipped) {
    result.mechanism = std::filesystem::path(mechanism.file).stem().string();
    own = read_shipped(*find_shipped(result.mechanism)).load;
  } else if (auto bodies = file_by_bodies(mechanism)) {
    result.file = std::move(bodies->first);
    own = bodies->second.load;
  } else {
    result.file = to_toml(mechanism);
  }
  if (mechanism.load && (!own || own->symbol != mechanism.load->symbol)) result.along = mechanism.load->symbol;
  result.scene = to_toml(scene, result.mechanism, result.along);
  return result;
}

}  // namespace slipproof
