// A contact problem in certificates: its name, by which they refer to it, and its short form
// (src/proofs/check_contact/FORMAT.md).
#pragma once

#include <optional>
#include <string>

#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// A canonical text, equal for equal problems in any file format. Linear in the problem's entries.
std::string canonical_form(const MixedProblem& problem);

/// SHA-256 of the canonical form, in hexadecimal.
std::string problem_name(const MixedProblem& problem);

/// A number of rows such that each entry above the diagonal is that below, but for its sign where just one of row and
/// column is below this number: then half of the matrix is enough. Nothing if there is none.
std::optional<std::size_t> turned_rows(const SparseMatrix& A);

}  // namespace slipproof
