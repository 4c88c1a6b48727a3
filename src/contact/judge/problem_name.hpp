// The name of a contact problem, by which certificates refer to it (src/proofs/check_contact/FORMAT.md).
#pragma once

#include <string>

#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// A canonical text, equal for equal problems in any file format. Linear in the problem's entries.
std::string canonical_form(const MixedProblem& problem);

/// SHA-256 of the canonical form, in hexadecimal.
std::string problem_name(const MixedProblem& problem);

}  // namespace slipproof
