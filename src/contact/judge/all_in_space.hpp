// All solutions of a contact problem by a tree of patterns (contact/complete), as the judge and certificates use them.
#pragma once

#include <optional>

#include "contact/complete/complete.hpp"
#include "contact/judge/all_solutions.hpp"

namespace slipproof {

/// What was found, and what a certificate needs of the problem's free unknowns.
struct SolutionTree {
  CompleteSolutions solutions;
  RationalMatrix eliminated;  ///< the inverse of the block of free unknowns; empty where there are none
};

/// By Coulomb's law; nothing where free unknowns are not determined by forces, or there are more than 60 of them.
/// Throws NumberError for NaN and infinities, and std::runtime_error in a build without Clp.
std::optional<SolutionTree> solution_tree(const MixedProblem& problem, Work effort,
                                          const SearchProgress& progress = {});

/// In the units of the problem, without free unknowns. Patterns that stay open are named.
AllSolutions all_solutions_of(const SolutionTree& tree);

}  // namespace slipproof
