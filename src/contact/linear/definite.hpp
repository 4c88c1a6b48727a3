// Matrices with x . A x > 0 for all x but 0, and factors that show it.
#pragma once

#include <optional>

#include "base/algebra/sparse_matrix.hpp"
#include "base/number/effort.hpp"

namespace slipproof {

/// Whether each row of A + A^T - L L^T has its diagonal entry greater than the sum of the absolute values of the
/// others; L has no entry above its diagonal. Then that matrix is positive definite (Gershgorin), and A + A^T with it.
/// Floating point with error bounds decides most rows; the others are computed again without rounding.
bool is_definite(const SparseMatrix& A, const SparseMatrix& L);

/// Such an L, which was checked, for a square matrix with a positive diagonal; nothing where none was found. The rows
/// are eliminated in their order. Throws TooMuchWork.
std::optional<SparseMatrix> definite_factor(const SparseMatrix& A, Effort& effort);

}  // namespace slipproof
