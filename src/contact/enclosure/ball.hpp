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
  double error = 0;                   ///< upper bound on the norm of what rounding changed in the matrix
  SparseFactor factor;
};

/// Nothing where the elimination breaks down, or the matrix is singular as far as binary64 can tell.
std::shared_ptr<const SparseInverse> sparse_inverse(const ModeSystem& system, const SystemBlock& block,
                                                    std::span<const double> z);

/// Whether the block has at least so many unknowns, and nearly all entries of its derivative are 0; with 0: always.
bool is_large_and_sparse(const ModeSystem& system, const SystemBlock& block, std::span<const double> z,
                         std::size_t large);

/// As krawczyk(); the block has its sparse inverse.
std::optional<KrawczykBox> enclose_in_ball(const ModeSystem& system, const SystemBlock& block,
                                           std::span<const double> z);

/// What a certificate says of a whole system at once (FORMAT.md, `ball`).
struct BallProof {
  std::vector<Rational> center;      ///< of all unknowns
  std::vector<double> radius, rows;  ///< powers of 2; the radius of a pinned unknown is 1
  double least = 0, defect = 0, bend = 0;
  std::vector<SingularValueProof::Entry> factor;
};

/// Of an enclosure whose blocks are large and sparse. Nothing where their norms together are too coarse.
std::optional<BallProof> prove_in_ball(const Enclosure& enclosure);

}  // namespace slipproof
