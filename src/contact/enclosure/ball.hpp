// Krawczyk's test for large sparse blocks, in the Euclidean norm: no inverse is formed (contact/MATHEMATICS.md, "Large
// blocks").
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "contact/enclosure/enclosure.hpp"
#include "contact/linear/singular_value.hpp"

namespace slipproof {

/// The derivative of a block's equations with rows and columns scaled by powers of 2, D J E, and its factors.
struct SparseInverse {
  SparseMatrix matrix;
  std::vector<double> rows, columns;  ///< the diagonals of D and E
  double error = 0;                   ///< upper bound on the norm of the rounding error of the matrix
  SparseFactor factor;
};

/// Nothing if the elimination breaks down, or if the matrix is singular to binary64 precision.
std::shared_ptr<const SparseInverse> sparse_inverse(const ModeSystem& system, const SystemBlock& block,
                                                    std::span<const double> z);

/// True if the block has at least this number of unknowns and nearly all entries of its derivative are 0; always true
/// for 0.
bool is_large_and_sparse(const ModeSystem& system, const SystemBlock& block, std::span<const double> z,
                         std::size_t large);

/// Like krawczyk(), for a block with a sparse inverse.
std::optional<KrawczykBox> enclose_in_ball(const ModeSystem& system, const SystemBlock& block,
                                           std::span<const double> z);

/// The proof for all unknowns together in a certificate (FORMAT.md, `ball`).
struct BallProof {
  std::vector<Rational> center;      ///< by unknown
  std::vector<double> radius, rows;  ///< powers of 2; the radius of a pinned unknown is 1
  double least = 0, defect = 0, bend = 0;
  int grid = 0;
  std::vector<std::size_t> order;  ///< of the unknowns that are not pinned
};

/// Proves an enclosure whose blocks are large and sparse. Nothing if the norm of all blocks together is too coarse.
std::optional<BallProof> prove_in_ball(const Enclosure& enclosure);

}  // namespace slipproof
