// The certificate checker: a proof by contradiction from the assumptions and the negated conclusion of a statement,
// by case splits, derived sign conditions, witnesses and Positivstellensatz identities (proofs/FORMAT.md).
#pragma once

#include <istream>

#include "check/statement.hpp"

namespace slipproof::check {

inline constexpr std::size_t kMaxDepth = 1'000;
inline constexpr std::size_t kMaxHypotheses = 20'000;

/// Returns if the certificate proves the statement; otherwise throws Failure with the rule and the certificate's line
/// that break the format. Reads the certificate line by line.
void check_certificate(const Statement& statement, std::istream& certificate);

}  // namespace slipproof::check
