// Exact numbers between Python and the library.
#pragma once

#include <pybind11/pybind11.h>

#include "base/number/rational.hpp"

namespace slipproof::python {

/// (numerator, denominator) as Python integers, in lowest terms: what fractions.Fraction is made of.
pybind11::tuple to_python(const Rational& x);

}  // namespace slipproof::python
