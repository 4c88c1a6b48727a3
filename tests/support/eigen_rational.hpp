// Rational numbers for Eigen's dense solvers.
#pragma once

#include <Eigen/Dense>

#include "base/number/rational.hpp"

template <>
struct Eigen::NumTraits<slipproof::Rational> : Eigen::GenericNumTraits<slipproof::Rational> {
  using Real = slipproof::Rational;
  using NonInteger = slipproof::Rational;
  using Literal = slipproof::Rational;
  using Nested = slipproof::Rational;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 4,
    AddCost = 40,
    MulCost = 60
  };
  static Real epsilon() { return 0; }
  static Real dummy_precision() { return 0; }
  static int digits10() { return 0; }
};
