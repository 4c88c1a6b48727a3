// Symmetric matrices without negative eigenvalues that meet linear equations, nearly: in binary64, by CSDP, a program
// of its own that need not be there. What comes back is a proposal, which rounding.hpp turns into an exact answer or
// drops.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace slipproof::prove::sums {

/// A place in a symmetric matrix: row <= column; an entry off the diagonal counts for both of its places.
struct MatrixPlace {
  std::size_t block = 0, row = 0, column = 0;
};

/// The sum of factor * X(place) over the terms, with two places for an entry off the diagonal, is `sum`.
struct MatrixEquation {
  std::vector<std::pair<MatrixPlace, double>> terms;
  double sum = 0;
};

struct MatrixEquations {
  std::vector<std::size_t> sizes;  ///< sizes of the blocks
  std::vector<MatrixEquation> equations;
};

using DenseBlock = std::vector<double>;  ///< row by row, symmetric

struct MatrixPoint {
  double margin = 0;  ///< the least eigenvalue of all blocks; at most 1
  std::vector<DenseBlock> blocks;
};

/// Whether CSDP is installed, as a program `csdp` in PATH.
bool has_semidefinite_solver();

/// Matrices that meet the equations, which are independent, with the largest margin, below 0 where there are no
/// semidefinite ones; nothing where the solver fails. One thread, and processor-dependent kernels of OpenBLAS switched
/// off.
std::optional<MatrixPoint> widest_point(const MatrixEquations& problem);

}  // namespace slipproof::prove::sums
