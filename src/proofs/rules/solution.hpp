// The equations of the conclusion, solved for the unknowns that are to exist. Elimination does it, on the assumption
// that what is sought is linear in the unknowns one after another, with pivots whose signs the hypotheses settle.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/branch/state.hpp"
#include "proofs/rules/quotient.hpp"

namespace slipproof::prove {

struct Solution {
  std::vector<Quotient> quotients;                 ///< of each unknown, in the unknowns that are left free
  std::optional<std::vector<std::string>> values;  ///< with 0 for those, where that is defined
  std::optional<Polynomial> open_pivot;            ///< a factor of unknown sign that stood in the way
};

/// The disjunction that the conclusion has as a part, such as one of contact modes; nullptr if it has none.
const Formula* alternatives_in(const Formula& shown);

/// By the equations of the conclusion, where it has alternatives with those of one of them.
Solution solve_conclusion(Context& context, const State& state, std::size_t alternative = 0);

}  // namespace slipproof::prove
