// Scene files of the bicycle in the words of the paper: a shorthand for scenes of the shipped mechanism `bicycle`.
#pragma once

#include <string>
#include <string_view>

#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// The shipped mechanism `bicycle`.
const Mechanism& bicycle_mechanism();
/// The index of one of its parameters.
std::size_t bicycle_parameter(std::string_view symbol);
/// Whether a mechanism is this one, by its name and its symbols.
bool is_bicycle(const Mechanism& mechanism);

/// The scene that the tables of a file describe; `file` gives its name where it has none. Mistakes are reported.
///
/// - [bicycle]: R; h or h0 = h + R; b or b2, b3; I1, I2, I3 or M2, M3; r1, r2 or mu; L; optional M (1) and J. mu gives
///   r1 = 1, r2 = mu. M2 and M3 are the reduced form of section 3 of the paper: M = 1, mu = 1, I1 = 0, I2 = M2 R^2,
///   I3 = M3 R^2; without L, sigma = 1 there if the force is internal, so that F is the paper's P.
/// - [road]: f, g.
/// - [force]: kind, "internal" or "external"; optional F, or P = F sigma if internal.
/// - name: optional; the name of the file without its extension.
///
/// The notes of the scene say what was not written but understood. b, h0 and mu are combined parameters of the scene.
MechanismScene read_bicycle_scene(const TomlValue& document, const std::string& file, Mistakes& mistakes);

}  // namespace slipproof
