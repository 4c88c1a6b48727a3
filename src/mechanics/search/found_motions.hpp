// Which motions a mechanism has at one point, for every load at once, and what they come to.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/impact/impact_energy.hpp"
#include "mechanics/kernel/motions.hpp"
#include "mechanics/points/problem.hpp"

namespace slipproof {

/// What is found at one load.
enum class MotionCount : std::uint8_t {
  one,
  none,
  none_modelled,  ///< none in a problem in which some contact that may open does not: see lift_needs
  several,
  continuum,
  hysteresis,  ///< several, but one where the static coefficients are as low as the kinetic ones
  undecided    ///< in space: there may be more than what was found
};
inline constexpr std::size_t motion_counts = 7;
/// `one`, `none`, `none_modelled`, `several`, `continuum`, `hysteresis`, `undecided`.
std::string_view name(MotionCount count);

/// The motions at one load by their modes, sorted. A motion on a boundary of modes, strict in none, is only counted:
/// which modes meet there is the same for no two neighbours.
struct FoundMotions {
  MotionCount count = MotionCount::one;
  std::vector<std::vector<MechanismMode>> modes;  ///< of each motion that is strict in some, those
  std::size_t on_boundary = 0;                    ///< motions that are strict in none
  std::vector<MechanismMode> continua;
  std::vector<std::size_t> not_modelled;   ///< contacts that do not open for want of a parameter
  std::vector<std::string> in_space = {};  ///< there the modes of the motions, in place of `modes`: `slip/lift`
  /// Of an impact: the greatest of its outcomes' balances.
  EnergyBalance energy = EnergyBalance::not_judged;

  std::size_t motions() const { return modes.size() + on_boundary + in_space.size(); }
  auto operator<=>(const FoundMotions&) const = default;
};

/// Finds the motions of a mechanism in space at a point; it has no load. Throws NoValue.
using FindInSpace = std::function<FoundMotions(const Mechanism&, const MechanismValues&)>;

/// Loads at which the same motions are found.
struct FoundOverLoads {
  FoundMotions found;
  ForceInterval loads;  ///< a point, or an open interval; the whole line without a load
};

/// Divides all loads of the domain, from below. The problem's equations must be solved (without_equations), with at
/// most max_modes modes. If hysteresis is kept apart, loads of several motions are divided where it begins and ends.
std::vector<FoundOverLoads> found_over_loads(const FrictionProblem& problem,
                                             const std::vector<std::size_t>& not_modelled, bool hysteresis_apart);

/// The outcomes of an impact, whose problem has no load; the rest is as before.
FoundMotions found_outcomes(const FrictionProblem& problem, const std::vector<std::size_t>& not_modelled,
                            const ImpactEnergy& energy);

}  // namespace slipproof
