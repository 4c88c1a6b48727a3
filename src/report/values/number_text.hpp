// Exact numbers and intervals as text for people.
#pragma once

#include <string>
#include <string_view>

#include "mechanics/elements/force_interval.hpp"
#include "mechanics/kernel/motion.hpp"

namespace slipproof {

/// A short number exactly; a longer one as a decimal with this many significant digits, then exactly, or, beyond
/// `longest` characters, how long that is. The unit follows the decimal.
std::string number_text(const Rational& x, int digits, const std::string& unit = {}, std::size_t longest = 44);

/// `[0.5, 3.33333)`; for a point `F = 0.5`.
std::string interval_text(std::string_view symbol, const ForceInterval& interval, int digits);

/// A point as number_text() does. What both ends say in these digits goes on with `...`: JSON has the ends.
std::string range_text(const Range& range, int digits, const std::string& unit = {});

/// A short number exactly, a longer one as a decimal.
std::string short_text(const Rational& x, int digits);

}  // namespace slipproof
