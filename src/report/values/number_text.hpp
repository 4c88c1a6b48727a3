// Exact numbers and intervals of them for people.
#pragma once

#include <string>
#include <string_view>

#include "mechanics/elements/force_interval.hpp"

namespace slipproof {

/// Short exact numbers stand alone; longer ones follow their decimal, of so many significant digits.
std::string number_text(const Rational& x, int digits);

/// `[0.5, 3.33333)`, of a point `F = 0.5`.
std::string interval_text(std::string_view symbol, const ForceInterval& interval, int digits);

}  // namespace slipproof
