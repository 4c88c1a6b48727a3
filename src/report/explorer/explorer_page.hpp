// The explorer: one HTML file that holds the library, compiled to WebAssembly, and a scene.
#pragma once

#include <string>

#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// The built page (src/faces/explorer) with a scene in it. Throws InputError, which names `file`, if `built` is no such
/// page.
std::string explorer_page(const std::string& built, const std::string& file, const MechanismScene& scene);

/// A link that opens a scene in the built page, which is at `page` and has no scene of its own: the scene is the part
/// after `#`. It takes about 1.5 kB, and 1.5 times the mechanism's file if the mechanism is not shipped.
std::string explorer_link(const std::string& page, const MechanismScene& scene);

}  // namespace slipproof
