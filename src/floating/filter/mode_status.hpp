// Judging contact modes over a number type whose signs may be uncertain.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "floating/filter/vector_kernel.hpp"
#include "mechanics/bicycle/contact_mode.hpp"
#include "mechanics/bicycle/reduction.hpp"

namespace slipproof {

enum class ModeStatus : std::uint8_t {
  inconsistent,  ///< some condition is violated
  consistent,    ///< every condition holds strictly
  undecided      ///< some sign is uncertain, or the mode may be singular
};

/// conditions() without an allocation.
struct ConditionList {
  std::array<Condition, 6> items{};
  int count = 0;
};

constexpr ConditionList condition_list(ContactMode mode) {
  ConditionList list;
  for (const Wheel w : {Wheel::rear, Wheel::front}) {
    for (const StateCondition c : conditions(ElementKind{}, mode[w])) {
      list.items[static_cast<std::size_t>(list.count++)] = {w, c};
    }
  }
  return list;
}

/// Sets of contact modes, bit i for the mode with index i.
struct ModeSets {
  std::uint16_t consistent = 0;
  std::uint16_t undecided = 0;
};

/// 1 for a certainly positive number, 2 for a certainly negative one, 0 where the sign is uncertain.
template <class N>
inline int certain_sign(const N& x) {
  return certainly_positive(x) ? 1 : certainly_negative(x) ? 2 : 0;
}

/// The status of one mode. N offers the reduction's operations, certainly_positive(N) and
/// certainly_negative(N), both false where the sign is uncertain; or a faster certain_sign(N).
template <class N, ContactMode mode>
SLIPPROOF_FLATTEN inline ModeStatus mode_status(const ReducedDynamics<N, N>& dynamics) {
  constexpr ConditionList list = condition_list(mode);
  const ReducedMotion<N, N> motion(dynamics, mode);
  const int orientation = certain_sign(motion.determinant());
  if (orientation == 0) return ModeStatus::undecided;
  int certain = orientation;
#pragma GCC unroll 6
  for (int i = 0; i < list.count; ++i) {
    const int side = certain_sign(motion.condition_value(list.items[static_cast<std::size_t>(i)]).numerator);
    if ((side | orientation) == 3) return ModeStatus::inconsistent;
    certain &= side;
  }
  return certain != 0 ? ModeStatus::consistent : ModeStatus::undecided;
}

/// The status of all modes that are modelled: 9 with both wheels on the road, 16 with detachment.
template <class N>
inline ModeSets decide_modes(const ReducedDynamics<N, N>& dynamics, bool detachment) {
  // A wheel that may have no inertia may spin as it likes: its modes may be singular.
  const bool rear_spins = !certainly_positive(dynamics.A), front_spins = !certainly_positive(dynamics.I3);
  ModeSets sets;
  const auto judge = [&]<std::size_t index>() {
    constexpr ContactMode mode = all_modes()[index];
    const bool free =
        (rear_spins && mode.rear != ContactState::stick) || (front_spins && mode.front != ContactState::stick);
    const ModeStatus status = free ? ModeStatus::undecided : mode_status<N, mode>(dynamics);
    if (status == ModeStatus::inconsistent) return;
    auto& set = status == ModeStatus::consistent ? sets.consistent : sets.undecided;
    set = static_cast<std::uint16_t>(set | 1U << index);
  };
  const auto all = [&]<bool on_road, std::size_t... index>(std::index_sequence<index...>) {
    (
        [&] {
          if constexpr (all_modes()[index].on_road() == on_road) judge.template operator()<index>();
        }(),
        ...);
  };
  all.template operator()<true>(std::make_index_sequence<16>());
  if (detachment) all.template operator()<false>(std::make_index_sequence<16>());
  return sets;
}

}  // namespace slipproof
