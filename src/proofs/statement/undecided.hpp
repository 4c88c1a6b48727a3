// The record in place of a certificate if the search for a proof ended without one: a file NAME.cert that says so.
// Nobody can then take the statement for proved, for refused or for never tried.
//
//     slipproof-undecided 1
//     theorem NAME
//     because REASON         (any number of lines)
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proofs/statement/refutation_text.hpp"

namespace slipproof {

std::string undecided_text(const std::string& theorem, const std::vector<std::string>& reasons);

/// The reason that a statement is false at these numbers.
std::string false_at(const NamedValues& values);
/// `x = 1/2, y = 3`.
std::string at_numbers(const NamedValues& values);
/// The numbers of false_at() that such a file gives; nothing if it gives none.
std::optional<NamedValues> numbers_of(std::string_view undecided);

}  // namespace slipproof
