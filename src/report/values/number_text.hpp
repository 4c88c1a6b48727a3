// Exact numbers and intervals as text for people.
#pragma once

#include <string>
#include <string_view>

#include "mechanics/elements/force_interval.hpp"
#include "mechanics/kernel/motion.hpp"

namespace slipproof {

/// A short number exactly; a longer one as a decimal with this many significant digits, then exactly, or how long that
/// is.
std::string number_text(const Rational& x, int digits);

/// `[0.5, 3.33333)`; for a point `F = 0.5`.
std::string interval_text(std::string_view symbol, const ForceInterval& interval, int digits);

/// A point as number_text() does. What both ends say in these digits goes on with `...`: JSON has the ends.
std::string range_text(const Range& range, int digits);

/// A short number exactly, a longer one as a decimal.
std::string short_text(const Rational& x, int digits);

}  // namespace slipproof
