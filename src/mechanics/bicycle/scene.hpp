// Scene files: a bicycle, a road and a force as a person writes them down.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "mechanics/bicycle/bicycle.hpp"

namespace slipproof {

/// Reads a scene file. Throws InputError with every mistake of the file, in the order of their places.
///
/// - [bicycle]: R; h or h0 = h + R; b or b2, b3; I1, I2, I3 or M2, M3; r1, r2 or mu; L; optional M (1) and J. mu gives
///   r1 = 1, r2 = mu. M2 and M3 are the reduced form of section 3 of the paper: M = 1, mu = 1, I1 = 0, I2 = M2 R^2,
///   I3 = M3 R^2; without L, sigma = 1 there if the force is internal, so that F is the paper's P.
/// - [road]: f, g.
/// - [force]: kind, "internal" or "external"; optional F, or P = F sigma if internal.
/// - name: optional; the name of the file without its extension.
///
/// Domains are those of Bicycle and Road. What was not written but understood stands in Scene::notes.
Scene read_scene(const std::filesystem::path& path);

/// The same from a text; `file` is how messages call it.
Scene parse_scene(std::string_view text, const std::string& file);

/// A scene file that reads back as the same scene, apart from its notes. Numbers are exact, so one of more than
/// max_number_length characters is written but not read back.
std::string to_toml(const Scene& scene);

}  // namespace slipproof
