// Points of a mechanism's domain at which something might be undecided.
#pragma once

#include <cstdint>
#include <optional>

#include "base/number/dice.hpp"
#include "mechanics/points/domain_sampler.hpp"

namespace slipproof {

/// Samples of the whole domain. Sample i depends only on the seed and on i. The kinds take turns: mostly 1, small
/// integers, small fractions, ratios from 2^-20 to 2^20, and parameters that are equal, cancel, or lie on a bound of
/// the domain, so that thin sets are met. Every second sample is one that could be built, if there are any; optional
/// parameters are given and left out in turn.
class PointSampler {
 public:
  /// What is given must outlive the sampler.
  PointSampler(const Mechanism& mechanism, const ProblemMaker& maker, std::uint64_t seed)
      : mechanism_(&mechanism),
        seed_(seed),
        domain_(mechanism, maker),
        realisable_(mechanism, maker, PointsOf::realisable) {}

  /// Nothing if none was found in many tries.
  std::optional<MechanismValues> at(std::uint64_t i) const;

  const DomainSampler& domain() const { return domain_; }
  const DomainSampler& realisable() const { return realisable_; }

 private:
  std::vector<bool> given(std::uint64_t turn) const;

  const Mechanism* mechanism_;
  std::uint64_t seed_;
  DomainSampler domain_, realisable_;
};

}  // namespace slipproof
