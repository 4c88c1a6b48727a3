// A scene with its mechanism as texts.
#pragma once

#include <string>

#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// A scene in a form that does not depend on where its files are.
struct PortableScene {
  std::string scene;      ///< the text of a scene file that names `mechanism`
  std::string mechanism;  ///< a shipped mechanism's name, or `mechanism.toml`
  std::string along;      ///< as in the scene
  std::string file;       ///< the text of `mechanism.toml`, its own if it has bodies; empty for a shipped mechanism
};
PortableScene portable(const MechanismScene& scene);

}  // namespace slipproof
