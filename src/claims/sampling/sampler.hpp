// Rational bicycles to judge claims at: random ones, and those where something could go wrong.
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

/// Samples of a setting's parameters. Sample i depends on the seed and on i alone. The kinds take turns: small
/// integers, small fractions, exactly on a boundary of the claims file, next to one, between two, and ratios from
/// 2^-40 to 2^40.
class Sampler {
 public:
  /// What is given must outlive the sampler.
  Sampler(const CompiledSetting& setting, std::uint64_t seed, Among among = Among::all);

  /// Values of the parameters, inside their domains and such as are wanted; empty if none was found in many tries.
  std::vector<Rational> at(std::uint64_t i) const;

 private:
  const CompiledSetting* setting_;
  std::uint64_t seed_;
  Among among_;
  std::vector<SureCondition> domains_;  ///< of the setting
};

/// Whether the values are inside the domain of one parameter, of all parameters.
bool allows(const CompiledSetting& setting, std::size_t parameter, const std::vector<Rational>& values);
bool in_domain(const CompiledSetting& setting, const std::vector<Rational>& values);

/// Which of the setting's conditions on what can be built are not met, by their indices.
std::vector<std::size_t> unrealisable(const CompiledSetting& setting, const std::vector<Rational>& values);

/// The value of a boundary at a sample; nothing where it is undefined.
std::optional<Rational> boundary_value(const CompiledSetting& setting, const CompiledSetting::Boundary& boundary,
                                       const std::vector<Rational>& values);

}  // namespace slipproof
