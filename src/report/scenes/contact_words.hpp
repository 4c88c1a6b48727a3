// What was found about an answer to a contact problem, in words.
#pragma once

#include <string>
#include <vector>

#include "records/problems/contact_file.hpp"

namespace slipproof {

/// The result in words: which contacts violate which law, by how much, and whether the cause is the answer, the
/// pyramid, or the problem.
std::string contact_words(const JudgedProblem& problem, std::size_t answer);

/// What Coulomb's law says of the answer's forces, in a sentence or two; empty where that is what was judged.
std::string coulomb_words(const JudgedProblem& problem, std::size_t answer);

/// What the problem's file calls its units; empty where it does not.
struct ContactUnits {
  std::string force = {}, velocity = {};
};
ContactUnits units_of(const JudgedProblem& problem);

/// The sentence for the verdict.
std::string verdict_words(const ContactJudgement& judgement, const ContactUnits& units = {});
/// Further sentences, beyond verdict and backward error: why nothing stronger is proved, a pyramid for which the answer
/// is right, velocities that do not belong to the forces, undetermined forces and their ranges.
std::vector<std::string> further_words(const ContactJudgement& judgement, const ContactUnits& units = {});

}  // namespace slipproof
