// Converts exact numbers from the library to Python.
#pragma once

#include <pybind11/pybind11.h>

#include "base/number/rational.hpp"

namespace slipproof::python {

/// (numerator, denominator) as Python integers in lowest terms, for fractions.Fraction.
pybind11::tuple to_python(const Rational& x);

}  // namespace slipproof::python
