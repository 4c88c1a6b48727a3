// H-matrices: diagonally dominant once their columns are multiplied by the right positive numbers.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/algebra/sparse_matrix.hpp"
#include "base/number/effort.hpp"

namespace slipproof {

/// Every P-matrix has it. Linear.
bool has_positive_diagonal(const SparseMatrix& A);

/// Whether d > 0, a_ii > 0 and a_ii d_i > sum over j != i of |a_ij| d_j in every row, without rounding. Linear.
bool is_dominant(const SparseMatrix& A, std::span<const double> d);

/// Such a d, which was checked, for a square matrix with a positive diagonal; nothing where none was found. Throws
/// TooMuchWork.
std::optional<std::vector<double>> dominant_scale(const SparseMatrix& A, Effort& effort);

}  // namespace slipproof
