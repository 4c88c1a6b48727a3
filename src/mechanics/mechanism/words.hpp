// Conditions and modes of a mechanism in words.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// One condition of an element's state: `N1 >= 0`, `|S2| <= mu N2`, `slip_left <= 0`, `gap_left >= 0`; with > and < if
/// strict. The two halves of |S| <= mu N have the same name.
std::string condition_name(const Mechanism& mechanism, std::size_t element, ElementState state,
                           StateCondition condition, bool strict = false);

/// A mode as a file writes it, `*` for any state of an element: `stick/*`.
struct ModePattern {
  std::vector<std::optional<ElementState>> states;  ///< nothing: any
  bool matches(const MechanismMode& mode) const;
};

/// The mode in a text. What is none is reported at its place there, after `key`, and gives nothing: a wrong number of
/// states, or a state that the element does not have. `lift` is a state also where it is not modelled.
std::optional<ModePattern> parse_mode(const Mechanism& mechanism, const std::vector<ElementKind>& kinds,
                                      const PlacedText& text, std::string_view key, Mistakes& mistakes);

/// All modes that a pattern stands for, in the order of enumeration; the kinds decide which states there are.
std::vector<MechanismMode> modes_of(const ModePattern& pattern, const std::vector<ElementKind>& kinds);

}  // namespace slipproof
