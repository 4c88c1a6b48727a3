// Whether two mechanisms are the same for all values of their parameters.
#pragma once

#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof::test {

/// Names of unknowns, states, and the forms of equations, gaps, slips and links, as rational functions. Reports the
/// first difference to doctest. The second has all symbols of the first.
void check_same_mechanism(const Mechanism& one, const Mechanism& other);
/// Whether two expressions are the same rational function; the text is over the mechanism's symbols.
bool is_identical(const Mechanism& mechanism, const Expression& expression, const std::string& text);

}  // namespace slipproof::test
