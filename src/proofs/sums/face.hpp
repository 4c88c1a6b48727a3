// Facial reduction. Where a form has zeros, or a part of an ansatz cannot take part, every matrix that meets the
// equations has the same vectors in its kernel, and no rounded one keeps them. So the kernel is read off a matrix in
// binary64, guessed as rational vectors, and the basis restricted to what is orthogonal to them: there matrices with an
// inverse may be left, which can be rounded. A wrong guess costs a proof, never makes one.
#pragma once

#include <optional>

#include "proofs/sums/ansatz.hpp"
#include "proofs/sums/semidefinite.hpp"

namespace slipproof::prove::sums {

/// The ansatz without the kernels: eigenvectors whose eigenvalues are at most `threshold` times the largest of all.
/// Nothing if there are none, if they do not look rational, or if nothing strict is left.
std::optional<Ansatz> restricted_to_face(const Ansatz& ansatz, const MatrixPoint& point, double threshold);

}  // namespace slipproof::prove::sums
