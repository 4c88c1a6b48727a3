// Which motions a mechanism has at one point, for every load at once, and what they come to.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "mechanics/kernel/motions.hpp"

namespace slipproof {

/// What is found at one load.
enum class MotionCount : std::uint8_t {
  one,
  none,
  none_modelled,  ///< none in a problem in which some contact that may open does not: see lift_needs
  several,
  continuum,
  hysteresis  ///< several, but one where the static coefficients are as low as the kinetic ones
};
inline constexpr std::size_t motion_counts = 6;
/// `one`, `none`, `none_modelled`, `several`, `continuum`, `hysteresis`.
std::string_view name(MotionCount count);

/// The motions at one load by their modes, sorted. A motion on a boundary of modes, strict in none, is only counted:
/// which modes meet there is the same for no two neighbours.
struct FoundMotions {
  MotionCount count = MotionCount::one;
  std::vector<std::vector<MechanismMode>> modes;  ///< of each motion that is strict in some, those
  std::size_t on_boundary = 0;                    ///< motions that are strict in none
  std::vector<MechanismMode> continua;
  std::vector<std::size_t> not_modelled;  ///< contacts that do not open for want of a parameter

  std::size_t motions() const { return modes.size() + on_boundary; }
  auto operator<=>(const FoundMotions&) const = default;
};

/// Loads at which the same motions are found.
struct FoundOverLoads {
  FoundMotions found;
  ForceInterval loads;  ///< a point, or an open interval; the whole line without a load
};

/// Divides all loads of the domain, from below. The problem's equations must be solved (without_equations), with at
/// most max_modes modes. If hysteresis is kept apart, loads of several motions are divided where it begins and ends.
std::vector<FoundOverLoads> found_over_loads(const FrictionProblem& problem,
                                             const std::vector<std::size_t>& not_modelled, bool hysteresis_apart);

}  // namespace slipproof
