// Rational bicycles at which claims are judged: random ones, and those where errors are likely.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/expression/sure_condition.hpp"
#include "claims/paper/compiled.hpp"

namespace slipproof {

/// Which samples are wanted.
enum class Among : std::uint8_t {
  all,
  realisable  ///< those that meet all of Setting::realisable
};

/// Samples of a setting's parameters. Sample i depends only on the seed and i. The kinds of samples alternate: small
/// integers; small fractions; exactly on a boundary of the claims file, next to one, between two; ratios from 2^-40 to
/// 2^40.
class Sampler {
 public:
  /// All arguments must outlive the sampler.
  Sampler(const CompiledSetting& setting, std::uint64_t seed, Among among = Among::all);

  /// Values of the parameters inside their domains that meet `among`; empty if many tries found none.
  std::vector<Rational> at(std::uint64_t i) const;

 private:
  const CompiledSetting* setting_;
  std::uint64_t seed_;
  Among among_;
  std::vector<SureCondition> domains_;                ///< of the setting
  std::vector<std::optional<Rational>> only_values_;  ///< by parameter, if its domain allows one constant only
};

/// The indices of the setting's conditions for realisable points that are not met.
std::vector<std::size_t> unrealisable(const CompiledSetting& setting, const std::vector<Rational>& values);

/// The value of a boundary at a sample; nothing if it is undefined.
std::optional<Rational> boundary_value(const CompiledSetting& setting, const CompiledSetting::Boundary& boundary,
                                       const std::vector<Rational>& values);

}  // namespace slipproof
