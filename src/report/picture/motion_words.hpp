// Texts in pictures about a motion's forces and modes.
#pragma once

#include <optional>
#include <string>

#include "mechanics/kernel/motions.hpp"

namespace slipproof {

/// The value of a force in a picture: its own, or one in its range; nothing if all numbers are possible.
std::optional<Rational> shown_value(const Range& range);

/// `= 3`, `≈ 3.142`.
std::string value_text(const Rational& x);
/// The same for a range that is a point; otherwise `in [0, 5/2]`.
std::string range_text(const Range& range);

/// The state of an element if it is the same in all modes of a motion; otherwise empty.
std::string common_state(const MotionAtLoad& motion, std::size_t element);
/// The names of the motion's modes, at most three, and whether they hold only at a boundary.
std::string modes_text(const MotionAtLoad& motion);

}  // namespace slipproof
