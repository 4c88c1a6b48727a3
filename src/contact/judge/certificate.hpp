// Certificates about contact problems, as src/proofs/check_contact/FORMAT.md has them: what a separate program checks
// again.
#pragma once

#include <string>

#include "contact/judge/judge.hpp"

namespace slipproof {

/// The certificate of what was found, whole; empty where nothing is proved that has one (an invalid answer). Linear in
/// the problem's entries and those of the blocks' inverses.
std::string contact_certificate(const MixedProblem& problem, const ContactJudgement& judgement);

}  // namespace slipproof
