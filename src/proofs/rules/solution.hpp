// Solves the equations of the conclusion for the unknowns of `exists`. Uses elimination, on the assumption that the
// equations are linear in the unknowns one after another, with pivots whose signs the hypotheses determine.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/branch/state.hpp"
#include "proofs/rules/quotient.hpp"

namespace slipproof::prove {

struct Solution {
  std::vector<Quotient> quotients;                 ///< by unknown, in terms of the free unknowns
  std::optional<std::vector<std::string>> values;  ///< values with 0 for the free unknowns, if that is defined
  std::optional<Polynomial> open_pivot;            ///< a factor of unknown sign that stood in the way
};

/// The disjunction that the conclusion has as a part, such as one of contact modes; nullptr if it has none.
const Formula* alternatives_in(const Formula& shown);

/// Uses the equations of the conclusion or, if it has alternatives, those of one of them.
Solution solve_conclusion(Context& context, const State& state, std::size_t alternative = 0);

}  // namespace slipproof::prove
