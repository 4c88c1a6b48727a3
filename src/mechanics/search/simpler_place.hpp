// Simple places at which given motions are found: ones that a person can check by hand.
#pragma once

#include <optional>
#include <utility>

#include "base/number/simplest.hpp"
#include "mechanics/search/found_motions.hpp"
#include "mechanics/search/points.hpp"

namespace slipproof {

struct SearchPlace {
  MechanismValues values;
  std::optional<Rational> load;  ///< nothing in a mechanism without one
};

/// Complexity of the given parameters, the cosine and sine of each angle, and the load.
Complexity complexity(const SearchPlace& place);

/// The motions at the points of one mechanism.
class MotionFinder {
 public:
  /// The mechanism must outlive the finder. `in_space` is for one in space.
  MotionFinder(const Mechanism& mechanism, bool hysteresis_apart, FindInSpace in_space = {})
      : mechanism_(&mechanism),
        maker_(mechanism),
        hysteresis_apart_(hysteresis_apart),
        in_space_(std::move(in_space)) {}
  const ProblemMaker& maker() const { return maker_; }

  /// For all loads of the domain, from below; none if it has no load. Throws NoValue.
  std::vector<FoundOverLoads> at(const MechanismValues& values) const;

  /// The simplest load, of all that at() gave, at which just these motions are found.
  std::optional<SearchPlace> place_of(const FoundMotions& wanted, const std::vector<FoundOverLoads>& all,
                                      const MechanismValues& values) const;

 private:
  const Mechanism* mechanism_;
  ProblemMaker maker_;
  bool hysteresis_apart_;
  FindInSpace in_space_;
};

/// Replaces single values, or all that are equal or opposite, by simpler ones as long as the same motions are found in
/// the domain, at most `budget` times trying. Equations of the domain are kept.
SearchPlace simpler(SearchPlace place, const FoundMotions& wanted, const MotionFinder& finder,
                    const DomainSampler& domain, std::size_t budget);

}  // namespace slipproof
