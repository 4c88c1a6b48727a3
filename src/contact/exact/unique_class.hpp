// Why a contact problem has exactly one solution for every constant: classes of matrices without friction, theorems of
// contact/problem/every_load.hpp with friction in the plane.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "base/number/effort.hpp"
#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// True for a linear complementarity problem in finite numbers: no free unknowns, no tangential components.
bool is_complementarity(const MixedProblem& problem);

/// True for contacts in dimension 2 without free unknowns, in finite numbers.
bool is_planar_friction(const MixedProblem& problem);

/// Why a complementarity problem with some matrix has exactly one solution for every constant: each class is contained
/// in that of the P-matrices, for which this is the definition (Samelson, Thrall, Wesler 1958). Or why one with planar
/// friction has, with some matrix and mu.
struct UniqueProof {
  enum class Class : std::uint8_t {
    dominant,     ///< a_ii > 0, and a_ii d_i > sum over j != i of |a_ij| d_j: an H-matrix
    definite,     ///< x . A x > 0 for all x but 0
    p_matrix,     ///< all principal minors are positive; a checker has to compute them
    bound,        ///< planar friction: A less some multiples of mu is definite (lowered_by_friction())
    determinants  ///< planar friction: A is definite, and all mode determinants are positive; computed as for p_matrix
  };
  Class kind = Class::p_matrix;
  std::vector<double> scale;  ///< dominant: d > 0, of each column
  /// definite, bound, determinants: L, with no entry above its diagonal. In each row of A + A^T - L L^T the diagonal
  /// entry is greater than the sum of the absolute values of the others; for `bound`, A is the lowered one.
  SparseMatrix factor;
};

/// The name in messages and JSON: `P-matrix`.
std::string_view name(UniqueProof::Class kind);

/// Decides exactly whether the proof is valid. False if the problem is of another kind, if numbers are not finite, and
/// if sizes do not match; for `p_matrix` also above max_minors_size, for `determinants` above max_determinant_contacts.
/// Linear for `dominant`. For `definite` and `bound` it takes one L L^T in floating point, and an exact one if rounding
/// errors leave the result open.
bool proves(const UniqueProof& proof, const MixedProblem& problem);

/// A proof, checked; nothing if none was found within the effort. Floating point finds d and L: for 20,000 rows with a
/// few entries each d takes a tenth of a second, for 1,000 full rows L takes a second.
std::optional<UniqueProof> prove_unique(const MixedProblem& problem, Effort& effort);

/// For planar friction: A minus the bound of contact/problem/every_load.hpp on its diagonal, rounded down. Nothing if a
/// diagonal entry is then not positive.
std::optional<SparseMatrix> lowered_by_friction(const MixedProblem& problem);

/// There are 4^n mode determinants.
inline constexpr std::size_t max_determinant_contacts = 8;

/// There are 2^n principal minors.
inline constexpr std::size_t max_minors_size = 12;

/// The rows, in increasing order, of a principal minor that is not positive; nothing if A is a P-matrix. For at most
/// max_minors_size rows. With such a minor there is a constant for which the problem has no solution, or several.
std::optional<std::vector<std::size_t>> nonpositive_minor(const SparseMatrix& A);

}  // namespace slipproof
