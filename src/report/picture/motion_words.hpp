// What pictures tell of a motion's forces and modes beside what they draw.
#pragma once

#include <optional>
#include <string>

#include "mechanics/kernel/motions.hpp"

namespace slipproof {

/// The value of a force in a picture: its own, or one of its range; nothing if all numbers are possible.
std::optional<Rational> shown_value(const Range& range);

/// `= 3`, `≈ 3.142`.
std::string value_text(const Rational& x);
/// The same of a range that is a point; `in [0, 5/2]`.
std::string range_text(const Range& range);

/// What all modes of a motion say of an element; empty where they differ.
std::string common_state(const MotionAtLoad& motion, std::size_t element);
/// The names of its modes, three at most, and whether they hold at a boundary only.
std::string modes_text(const MotionAtLoad& motion);

}  // namespace slipproof
