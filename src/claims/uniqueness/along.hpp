// Finds exactly for which values of a parameter of a scene each load has one motion.
//
// The parameter, usually the coefficient of friction, runs along a line. The places where the answer can change are
// known exactly (mechanics/lines/critical.hpp), and so are the zeros of the mode determinants
// (contact/problem/every_load.hpp). Between two such values nothing changes, so one rational number there gives the
// answer for all.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/algebra/real_roots.hpp"
#include "contact/problem/every_load.hpp"
#include "mechanics/elements/force_interval.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// Neighbouring loads that do not have exactly one motion, and are alike in how many they have.
struct LoadsApart {
  ForceInterval loads;
  std::size_t motions = 0;  ///< motions that are not in a continuum
  bool continuum = false;

  bool none() const { return motions == 0 && !continuum; }
  bool is_like(const LoadsApart& other) const { return motions == other.motions && continuum == other.continuum; }
};

/// What is found at one value of the parameter.
struct MotionsAtParameter {
  std::vector<LoadsApart> apart;         ///< ascending; empty: there is one motion at every load of the domain
  std::optional<EveryLoad> for_every_q;  ///< nothing if the theorem does not apply to the contacts
};

/// A value of the parameter, or an open interval of values that are alike.
struct ParameterCell : LineCell {
  /// The result at the sample; nothing if the sample is outside the domain. At an irrational value, the result follows
  /// from its neighbours: if both have one motion for every q and no mode determinant vanishes between them, so does
  /// the value. Nothing if this does not decide it, because the value itself is not examined.
  std::optional<MotionsAtParameter> motions;
};

struct UniquenessAlong {
  std::string parameter;
  Rational own;  ///< the scene's value
  MotionsAtParameter at_own;
  std::vector<ParameterCell> cells;  ///< ascending, from one end of the domain to the other

  /// The least value above the first values that have one motion at every load at which, or directly above which, some
  /// load has no motion, several, or infinitely many. Nothing if there is no such value. An irrational one is enclosed.
  std::optional<RealRoot> first_apart() const;
  /// The same for other pushes: the least value at which, or directly above which, not every q has one motion.
  std::optional<RealRoot> first_apart_for_some_q() const;

 private:
  std::optional<RealRoot> first_where(bool (*holds)(const MotionsAtParameter&)) const;
};

/// The largest number of modes that are followed along a line.
inline constexpr std::size_t max_critical_modes = 128;

/// Throws std::invalid_argument, with a message for people, if the scene has no such parameter or has more modes;
/// NoValue if a coefficient of the scene itself has no value.
UniquenessAlong uniqueness_along(const MechanismScene& scene, const std::string& parameter);

}  // namespace slipproof
