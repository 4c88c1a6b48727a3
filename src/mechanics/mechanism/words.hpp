// Conditions and modes of a mechanism in words.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// A condition of an element's state as text: `N1 >= 0`, `|S2| <= mu N2`, `slip_left <= 0`, `gap_left >= 0`; with > and
/// < if strict. The two halves of |S| <= mu N have the same name.
std::string condition_name(const Mechanism& mechanism, std::size_t element, ElementState state,
                           StateCondition condition, bool strict = false);

/// A mode as a file writes it, `*` for any state of an element: `stick/*`.
struct ModePattern {
  std::vector<std::optional<ElementState>> states;  ///< nothing: any
};

/// Reads a mode. For a malformed one, such as a wrong number of states or a state that the element does not have,
/// reports a mistake at its place in the text, after `key`, and returns nothing. `lift` is a state even if it is not
/// modelled.
std::optional<ModePattern> parse_mode(const Mechanism& mechanism, const std::vector<ElementKind>& kinds,
                                      const PlacedText& text, std::string_view key, Mistakes& mistakes);

/// All modes that match a pattern, in the order of enumeration; the kinds determine the possible states.
std::vector<MechanismMode> modes_of(const ModePattern& pattern, const std::vector<ElementKind>& kinds);

}  // namespace slipproof
