// Contact states, contact modes, and the quantities of a motion: the vocabulary of proofs/MODEL.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "mechanics/elements/element.hpp"

namespace slipproof {

/// The state of a wheel: `stick`, `slip+`, `slip-` or `lift`.
using WheelState = ElementState;

enum class Wheel : std::uint8_t { rear, front };  ///< the paper's j = 2 and j = 3

/// One state for each wheel, written rear/front, as in `stick/slip+`.
struct ContactMode {
  WheelState rear = WheelState::stick;
  WheelState front = WheelState::stick;

  constexpr WheelState operator[](Wheel wheel) const { return wheel == Wheel::rear ? rear : front; }
  constexpr bool operator==(const ContactMode&) const = default;
  /// Both wheels on the road: then phi = a_y = 0 and the pitch inertia J drops out.
  constexpr bool on_road() const { return rear != WheelState::lift && front != WheelState::lift; }
  /// Position in all_modes().
  constexpr std::size_t index() const { return static_cast<std::size_t>(rear) * 4 + static_cast<std::size_t>(front); }
};

/// All 16 modes, in the order of their indices.
constexpr std::array<ContactMode, 16> all_modes() {
  std::array<ContactMode, 16> modes{};
  for (std::uint8_t i = 0; i < 16; ++i) modes[i] = {static_cast<WheelState>(i / 4), static_cast<WheelState>(i % 4)};
  return modes;
}

/// What a motion consists of, in the order in which it is written.
enum class Quantity : std::uint8_t { a, a_y, phi, eps2, eps3, S2, S3, N2, N3, gap2, gap3, slip2, slip3 };
inline constexpr std::size_t quantity_count = 13;

constexpr std::array<Quantity, quantity_count> all_quantities() {
  std::array<Quantity, quantity_count> all{};
  for (std::uint8_t i = 0; i < quantity_count; ++i) all[i] = static_cast<Quantity>(i);
  return all;
}

std::string name(ContactMode mode);  ///< `rear/front`
std::string_view name(Quantity quantity);

/// One value for each quantity; V is a number, or affine in F.
template <class V>
struct Motion {
  std::array<V, quantity_count> values{};

  V& operator[](Quantity quantity) { return values[static_cast<std::size_t>(quantity)]; }
  const V& operator[](Quantity quantity) const { return values[static_cast<std::size_t>(quantity)]; }
  bool operator==(const Motion&) const = default;
};

/// A condition on a wheel: its left-hand side must be >= 0, > 0 in a strict motion.
struct Condition {
  Wheel wheel;
  StateCondition kind;
  bool operator==(const Condition&) const = default;
};

}  // namespace slipproof
