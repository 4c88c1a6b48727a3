// The parts of a problem that say nothing of each other.
#pragma once

#include <vector>

#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// Free unknowns and contacts that share rows with each other only.
struct ContactPart {
  std::vector<std::size_t> free, contacts;
};

/// All parts of a problem. Nearly linear in the nonzeros.
std::vector<ContactPart> parts_of(const MixedProblem& problem);
/// The rows of a part in the whole problem: free ones, then those of its contacts.
std::vector<std::size_t> rows_of(const MixedProblem& problem, const ContactPart& part);
/// The part as a problem of its own, with its rows_of() in their order; of its law the kind is kept. Nearly linear in
/// the part.
MixedProblem part_of(const MixedProblem& problem, const ContactPart& part, const std::vector<std::size_t>& rows);
/// The free unknowns that depend on each other without contacts, as lists: bodies, and what joints connect.
std::vector<std::vector<std::size_t>> free_parts(const MixedProblem& problem);

}  // namespace slipproof
