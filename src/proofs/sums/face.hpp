// Facial reduction. If a form has zeros, or if a part of an ansatz must vanish, all matrices that satisfy the equations
// share vectors in their kernels, and rounding destroys this. So the kernel is computed in binary64, its vectors are
// guessed as rational ones, and the basis is restricted to their orthogonal complement, where invertible matrices may
// remain, which can be rounded. A wrong guess can cost a proof, but cannot create one.
#pragma once

#include <optional>

#include "proofs/sums/ansatz.hpp"
#include "proofs/sums/semidefinite.hpp"

namespace slipproof::prove::sums {

/// The ansatz without the kernels: eigenvectors whose eigenvalues are at most `threshold` times the largest of all.
/// Nothing if there are none, if they do not look rational, or if nothing strict is left.
std::optional<Ansatz> restricted_to_face(const Ansatz& ansatz, const MatrixPoint& point, double threshold);

}  // namespace slipproof::prove::sums
