// Several scenes side by side in vector registers: Tracked for each lane.
#pragma once

#include <cstdint>

#include "filter/bounds.hpp"
#include "filter/lane_vectors.hpp"
#include "filter/mode_status.hpp"

namespace slipproof {

/// Tracked, lane by lane. Of positive inputs value and magnitude are the same register until something is subtracted.
struct TrackedLanes {
  Lanes value{}, magnitude{};

  TrackedLanes() = default;
  explicit TrackedLanes(int constant)
      : value(Lanes{} + constant), magnitude(Lanes{} + (constant < 0 ? -constant : constant)) {}
  TrackedLanes(Lanes v, Lanes m) : value(v), magnitude(m) {}
  static TrackedLanes input(Lanes x) { return {x, absolute(x)}; }

  Lanes error() const { return magnitude * (error_roundings * unit_roundoff) + underflow_error; }

  friend TrackedLanes operator+(const TrackedLanes& x, const TrackedLanes& y) {
    return {x.value + y.value, x.magnitude + y.magnitude};
  }
  friend TrackedLanes operator*(const TrackedLanes& x, const TrackedLanes& y) {
    return {x.value * y.value, x.magnitude * y.magnitude};
  }
  friend TrackedLanes operator-(const TrackedLanes& x) { return {-x.value, x.magnitude}; }
  friend TrackedLanes operator-(const TrackedLanes& x, const TrackedLanes& y) {
    return {x.value - y.value, x.magnitude + y.magnitude};
  }
};

inline Lanes value_of(const TrackedLanes& x) {
  return x.value;
}

/// ModeSets of each lane. Aligned for the widest registers, which the compiler expects of it in the functions compiled
/// for them.
struct LaneSets {
  alignas(sizeof(LaneBits)) LaneBits consistent{};
  alignas(sizeof(LaneBits)) LaneBits undecided{};
};

/// decide_modes() for every lane, without a branch on a value.
template <class N>
inline LaneSets decide_lanes(const ReducedDynamics<N, N>& dynamics, bool detachment) {
  const LaneBits rear_spins = ~(dynamics.A.value > dynamics.A.error());
  const LaneBits front_spins = ~(dynamics.I3.value > dynamics.I3.error());
  LaneSets sets;
  const auto judge = [&]<std::size_t index>() {
    constexpr ContactMode mode = all_modes()[index];
    constexpr ConditionList list = condition_list(mode);
    const ReducedMotion<N, N> motion(dynamics, mode);
    const N determinant = motion.determinant();
    LaneBits known = absolute(determinant.value) > determinant.error();
    if (mode.rear != ContactState::stick) known &= ~rear_spins;
    if (mode.front != ContactState::stick) known &= ~front_spins;
    const LaneBits orientation = bits(determinant.value) & sign_bit();
    LaneBits violated{}, strict = known;
    for (int i = 0; i < list.count; ++i) {
      const N side = motion.condition_value(list.items[static_cast<std::size_t>(i)]).numerator;
      const Lanes value = from_bits(bits(side.value) ^ orientation), error = side.error();
      violated |= value < -error;
      strict &= value > error;
    }
    const LaneBits bit = LaneBits{} + (std::int64_t{1} << index);
    sets.consistent |= strict & bit;
    sets.undecided |= ~strict & ~(known & violated) & bit;
  };
  [&]<std::size_t... index>(std::index_sequence<index...>) {
    (
        [&] {
          if (all_modes()[index].on_road() || detachment) judge.template operator()<index>();
        }(),
        ...);
  }
  (std::make_index_sequence<16>());
  return sets;
}

}  // namespace slipproof
