// The explorer: one HTML file that holds the library, compiled to WebAssembly, and a scene.
#pragma once

#include <string>

#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// The built page (src/faces/explorer) with a scene in it. Throws InputError, which names `file`, if `built` is no such
/// page.
std::string explorer_page(const std::string& built, const std::string& file, const MechanismScene& scene);

}  // namespace slipproof
