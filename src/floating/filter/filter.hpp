// Which contact modes are consistent at one force: the answer of the exact solver at nearly the speed of binary64.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "floating/filter/double_double.hpp"
#include "floating/filter/mode_status.hpp"
#include "floating/filter/tracked.hpp"
#include "mechanics/bicycle/forced_scene.hpp"
#include "mechanics/bicycle_modes/motions.hpp"

namespace slipproof {

/// What decided, fastest first. Each tier gives the same answer as the exact one, or passes on.
enum class Tier : std::uint8_t { filter, double_double, exact };
inline constexpr std::size_t tier_count = 3;
std::string_view name(Tier tier);

using TierCounts = std::array<std::uint64_t, tier_count>;

/// Modes that are consistent at the force, bit i for the mode with index i. Without J only modes with both wheels on
/// the road are modelled.
struct ConsistentModes {
  std::uint16_t consistent = 0;  ///< the non-strict conditions hold for some motion of the mode
  std::uint16_t strict = 0;      ///< of these, the ones in which some motion holds all conditions strictly
  Tier tier = Tier::filter;
  bool operator==(const ConsistentModes&) const = default;
};

/// Each number rounded to the nearest binary64; the filter's bounds include that rounding.
ForcedScene<double> nearest_binary64(const ForcedScene<Rational>& scene);

/// The dynamics in a number type with error bounds. It must be a copy of the inputs: N::input(T) says what a T means.
template <class N, class T>
ReducedDynamics<N, N> tracked_dynamics(const ForcedScene<T>& scene) {
  const auto s = convert<T, N>(scene, [](const T& x) { return N::input(x); });
  return reduce<N, N>(s.bicycle, s.road, s.force_kind, s.F, N(1));
}

/// True where every input is finite and small enough for the error bounds to hold. Two numbers side by side: one by
/// one it would be a tenth of the filter's time.
inline bool within_input_limit(const ForcedScene<double>& s) {
  typedef double Pair __attribute__((vector_size(16)));
  typedef std::int64_t Bits __attribute__((vector_size(16)));
  const auto sizes = [](double x, double y) {
    return std::bit_cast<Pair>(std::bit_cast<Bits>(Pair{x, y}) & Bits{INT64_MAX, INT64_MAX});
  };
  const Bicycle<double>& p = s.bicycle;
  // NaN, or infinite, where an input is
  const Pair sum = ((sizes(p.M, p.R) + sizes(p.h, p.b2)) + (sizes(p.b3, p.I1) + sizes(p.I2, p.I3))) +
                   ((sizes(p.r1, p.r2) + sizes(p.L, p.J ? *p.J : 0)) + (sizes(s.road.f, s.road.g) + sizes(s.F, 0)));
  return sum[0] + sum[1] <= input_limit;
}

inline constexpr ModeSets all_undecided{0, 0xFFFF};

/// The first tier alone: no allocation, no exception, no dependence on the rounding of anything but + - *. Every number
/// may be the nearest binary64 of what is meant.
ModeSets filter_modes(const ForcedScene<double>& scene);

/// The second tier alone, for the numbers as they are. `rounded` is the scene's nearest_binary64().
ModeSets double_double_modes(const ForcedScene<double>& exact);
ModeSets double_double_modes(const ForcedScene<Rational>& exact, const ForcedScene<double>& rounded);

/// The last tier alone.
ConsistentModes exact_modes(const ForcedScene<Rational>& scene);

/// All tiers, for a scene in the domain (bicycle.hpp); throws NumberError for a NaN or an infinity.
ConsistentModes consistent_modes(const ForcedScene<double>& exact);
ConsistentModes consistent_modes(const ForcedScene<Rational>& exact);

}  // namespace slipproof
