// Arrays of NumPy.
#pragma once

#include <pybind11/numpy.h>

#include <vector>

namespace slipproof::python {

using Doubles = pybind11::array_t<double, pybind11::array::c_style>;

inline std::vector<double> copied(const Doubles& values) {
  return {values.data(), values.data() + values.size()};
}

}  // namespace slipproof::python
