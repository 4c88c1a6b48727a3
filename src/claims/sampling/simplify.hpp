// The simplest counterexample: one that a person can check by hand.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "base/number/simplest.hpp"
#include "claims/sampling/sampler.hpp"

namespace slipproof {

struct Simplified {
  std::vector<Rational> values;
  /// No simpler sample of these fails, among all with parameters tied to boundaries as here.
  bool minimal = false;
};

/// A simplest sample that `fails`, starting from one that does. If the failure is one of a boundary of the setting (it
/// is gone on both sides), the parameter stays tied to that boundary. All samples of height 1, 2, ... are tried in the
/// order of Complexity, at most `budget` of them; past that, single values are made simpler as long as it goes. Among
/// those that can be built, nothing is found if `failing` is not one and none of those tried is.
std::optional<Simplified> simplify(const CompiledSetting& setting, const std::vector<Rational>& failing,
                                   const std::function<bool(const std::vector<Rational>&)>& fails,
                                   Among among = Among::all, std::size_t budget = 50'000);

}  // namespace slipproof
