// Linear systems whose solution is not unique: the one near a point.
#pragma once

#include <optional>
#include <span>

#include "base/algebra/elimination.hpp"

namespace slipproof {

/// The nearest multiple of 2^-bits.
Rational nearest_multiple(double x, int bits);
/// The largest one that is not above x.
Rational rounded_down(const Rational& x, int bits);

struct NearSolution {
  std::vector<Rational> x;
  std::size_t open_directions = 0;  ///< that the system leaves open
};

/// A solution of a system, each row with its right side last, whose open unknowns are those of `near`, rounded to
/// multiples of 2^-bits. Nothing if there is no solution.
std::optional<NearSolution> solve_near(const RationalMatrix& system, std::span<const double> near, int bits);

}  // namespace slipproof
