#include "report/explorer/portable_scene.hpp"

#include <filesystem>

#include "mechanics/reading/shipped.hpp"
#include "mechanics/reading/write_mechanism.hpp"

namespace slipproof {

PortableScene portable(const MechanismScene& scene) {
  const Mechanism& mechanism = scene.mechanism;
  PortableScene result;
  result.mechanism = "mechanism.toml";
  if (mechanism.shipped) result.mechanism = std::filesystem::path(mechanism.file).stem().string();
  if (!mechanism.shipped) result.file = to_toml(mechanism);
  if (mechanism.shipped && mechanism.load) {
    const auto own = read_shipped(*find_shipped(result.mechanism)).load;
    if (!own || own->symbol != mechanism.load->symbol) result.along = mechanism.load->symbol;
  }
  result.scene = to_toml(scene, result.mechanism, result.along);
  return result;
}

}  // namespace slipproof
