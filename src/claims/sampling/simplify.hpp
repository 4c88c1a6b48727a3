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
  /// No simpler one of these samples fails, among all with parameters tied to boundaries as here.
  bool minimal = false;
};

/// A simplest sample that `fails`, starting from one that does. If the failure occurs only on a boundary of the
/// setting, and not on either side of it, the parameter stays tied to that boundary. Tries all samples of height 1, 2,
/// ... in the order of Complexity, at most `budget` of them; then makes single values simpler as long as possible. If
/// samples that can be built are wanted, returns nothing if `failing` cannot be built and none of those tried can.
std::optional<Simplified> simplify(const CompiledSetting& setting, const std::vector<Rational>& failing,
                                   const std::function<bool(const std::vector<Rational>&)>& fails,
                                   Among among = Among::all, std::size_t budget = 50'000);

}  // namespace slipproof
