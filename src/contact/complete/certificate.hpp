// The claim `all-solutions` of a certificate (src/proofs/check_contact/FORMAT.md).
#pragma once

#include <string>

#include "contact/complete/complete.hpp"

namespace slipproof {

/// The claim as text, in the units of the problem: its motions, and the tree with one node a line. `eliminated` is the
/// inverse of the block of free unknowns, empty where there are none. Empty if the solutions are not complete.
std::string all_solutions_claim(const CompleteSolutions& solutions, const RationalMatrix& eliminated = {});

}  // namespace slipproof
