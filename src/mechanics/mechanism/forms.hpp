// Linear forms of equations, gaps, slips and limits: extracted from their expressions, symbolically.
#pragma once

#include <string_view>

#include "base/input/diagnostic.hpp"
#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof {

/// Finds all forms of a mechanism from its expressions, and what contacts, friction elements and links add to equations
/// of [motion]. Reports an expression that is not linear in the unknowns and the load, with the offending product and
/// its place; also a gap, slip or zero without an acceleration. Skips null expressions. Linear in the length of the
/// file times the number of unknowns.
void derive_forms(Mechanism& mechanism, Mistakes& mistakes);

/// The mechanism with another parameter as its load; the previous load becomes the last parameter. The conditions on
/// the parameter become the load's domain. Throws InputError, with places in the mechanism's file, if there is no such
/// parameter, if it multiplies an unknown, or if the conditions on it are not an interval.
Mechanism with_load(const Mechanism& mechanism, std::string_view parameter);

/// The mechanism with its load, if it has one, as the last of its parameters.
Mechanism without_load(const Mechanism& mechanism);

/// The comparisons of the load's domain, as forms in the load alone.
struct LoadBound {
  Expression load, constant;  ///< load * (the load) + constant
  Relation relation;          ///< to 0: greater, greater_equal or equal
  PlacedExpression source;
};
/// Reports a domain that is not an interval for all values of the parameters.
std::vector<LoadBound> load_bounds(const Mechanism& mechanism, Mistakes& mistakes);

}  // namespace slipproof
