// Certificates about contact problems, as src/proofs/check_contact/FORMAT.md has them: what a separate program checks
// again.
#pragma once

#include <string>

#include "contact/judge/judge.hpp"

namespace slipproof {

/// The text of the certificate for a judgement; empty if the verdict has none (an invalid answer). Linear in the
/// entries of the problem and of the blocks' inverses.
std::string contact_certificate(const MixedProblem& problem, const ContactJudgement& judgement);

}  // namespace slipproof
