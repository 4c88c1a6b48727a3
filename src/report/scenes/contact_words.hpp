// What was found about an answer to a contact problem, in words.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "records/problems/contact_file.hpp"

namespace slipproof {

/// The result in words: which contacts violate which law, by how much, and whether the cause is the answer, the
/// pyramid, or the problem.
std::string contact_words(const JudgedProblem& problem, std::size_t answer);

/// The option of `certify` that helps after a verdict; empty if none does.
std::string advice(const ContactJudgement& judgement);

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
/// is right, velocities that do not belong to the forces, all solutions of a small problem and how they differ,
/// undetermined forces and their ranges.
std::vector<std::string> further_words(const ContactJudgement& judgement, const ContactUnits& units = {});

/// `contact 3`, or `row 2` of other unknowns; both count from 1.
std::string place_words(const std::optional<std::size_t>& contact, std::size_t row);
/// `1, 4, 7 and 20 more`: the numbers from 1 of at most so many contacts.
std::string numbers_words(const std::vector<std::size_t>& contacts, std::size_t most);

}  // namespace slipproof
