// Prints how a mechanism file was understood.
#pragma once

#include <string>
#include <vector>

#include "mechanics/checks/checks.hpp"
#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// Parameters with domains, units and meanings, every equation with the contact forces in it, contacts, friction
/// elements and links with their states, the number of modes, and the findings. Lines of 80 columns, unless a word is
/// longer.
std::string show_text(const Mechanism& mechanism, const std::vector<MechanismFinding>& findings);

}  // namespace slipproof
