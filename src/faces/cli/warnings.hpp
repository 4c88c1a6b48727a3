// Prints to stderr what looks wrong in the mechanisms that a command reads. The answers may be right all the same.
#pragma once

#include <string>

#include "claims/paper/claims_file.hpp"
#include "faces/cli/command.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof::cli {

/// Prints the findings of check_mechanism() that could be checked; nothing if quiet, or for a
/// shipped mechanism, which the tests check: at every start it would cost more than a solution.
void print_warnings(const Mechanism& mechanism, const CommonOptions& common);
/// Also those of the numbers of a scene.
void print_warnings(const MechanismScene& scene, const CommonOptions& common);
/// Prints the warnings of each mechanism of a claims file once.
void print_warnings(const ClaimsFile& claims, const CommonOptions& common);

/// Throws InputError for an impact, whose unknowns are no accelerations, in a command that asks for these.
void refuse_impact(const MechanismScene& scene, const std::string& command);

}  // namespace slipproof::cli
