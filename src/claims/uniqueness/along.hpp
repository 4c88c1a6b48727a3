// For which values of a parameter of a scene each load has one motion, exactly.
//
// The parameter, usually the coefficient of friction, runs along a line; where on it the answer can change is known
// exactly (verify/critical.hpp), and so is where a mode determinant vanishes (contact/every_load.hpp). Between two such
// values nothing changes, and one rational number there tells what all have in common.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/algebra/real_roots.hpp"
#include "contact/problem/every_load.hpp"
#include "mechanics/elements/force_interval.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// Loads at which there is not one motion: each alike.
struct LoadsApart {
  ForceInterval loads;
  std::size_t motions = 0;  ///< that no continuum contains
  bool continuum = false;

  bool none() const { return motions == 0 && !continuum; }
};

/// What a value of the parameter has to say.
struct MotionsAtParameter {
  std::vector<LoadsApart> apart;         ///< ascending; empty: one motion at every load of the domain
  std::optional<EveryLoad> for_every_q;  ///< nothing where the contacts are none that the theorem is about
};

/// A value of the parameter, or an open interval, in which everything is alike.
struct ParameterCell {
  std::optional<RealRoot> lower, upper;  ///< the same for a value; nothing: no end
  std::optional<Rational> sample;        ///< nothing at an irrational value
  /// At the sample; nothing where that is out of the domain. At an irrational value what follows from its neighbours:
  /// where both have one motion for every q and no mode determinant vanishes between them, it has, too. Nothing where
  /// that does not tell: what is there is not looked at.
  std::optional<MotionsAtParameter> motions;

  bool is_point() const { return lower && upper && lower->lower == upper->lower && lower->upper == upper->upper; }
};

struct UniquenessAlong {
  std::string parameter;
  Rational own;  ///< the scene's value
  MotionsAtParameter at_own;
  std::vector<ParameterCell> cells;  ///< ascending, from one end of the domain to the other

  /// The least value above the first ones that have one motion at every load, from which on or above which some load
  /// has none, several, or infinitely many; nothing if there is no such value. An irrational one is enclosed.
  std::optional<RealRoot> first_apart() const;
  /// The same of what would be pushed otherwise: from which on or above which not every q has one motion.
  std::optional<RealRoot> first_apart_for_some_q() const;
};

/// At most so many modes are followed along a line.
inline constexpr std::size_t max_critical_modes = 32;

/// Throws std::invalid_argument, with a message for people, for what is no parameter of the scene and for more modes;
/// NoValue where a coefficient of the scene itself has no value.
UniquenessAlong uniqueness_along(const MechanismScene& scene, const std::string& parameter);

}  // namespace slipproof
