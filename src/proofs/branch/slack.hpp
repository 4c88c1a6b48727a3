// Positivity after substitution by slack variables.
#pragma once

#include <optional>
#include <vector>

#include "proofs/branch/replacements.hpp"
#include "proofs/branch/samples.hpp"
#include "proofs/statement/proof.hpp"

namespace slipproof::prove {

/// A hypothesis p = 0, p > 0 or p >= 0 by its name.
struct Fact {
  std::string name;
  Polynomial p;
  Sign sign = Sign::zero;
  SampleSet fails = {};  ///< the samples for which it is false
};

/// multiplier * p = sum of `terms`, where every hypothesis in them is an inequality and those of the multiplier are
/// strict.
struct SlackForm {
  Product multiplier;
  std::vector<WeightedProduct> terms = {};
  bool strict = false;  ///< some term consists of strict hypotheses only, so p > 0; otherwise p >= 0
};

/// The number of variables replaced at a time, and of attempts.
struct SlackEffort {
  int depth, attempts;
};

/// Looks for coordinates in which all coefficients of p are positive: one variable after another is replaced by the
/// slack of a hypothesis that is linear in it. Uses inequalities only, and excludes replacements that a sample refutes;
/// p is negative at the samples `negative`.
std::optional<SlackForm> find_slack_form(const std::vector<Fact>& facts, const std::vector<Fact>& derived,
                                         const Polynomial& p, const SampleSet& negative, SlackEffort effort,
                                         Replacements& replacements);

}  // namespace slipproof::prove
