// What stands in place of a certificate where the search for a proof ended without one: a file NAME.cert that says so,
// so that nobody takes the statement for proved, for refused or for never tried.
//
//     slipproof-undecided 1
//     theorem NAME
//     because REASON         (any number of lines)
#pragma once

#include <string>
#include <vector>

namespace slipproof {

std::string undecided_text(const std::string& theorem, const std::vector<std::string>& reasons);

}  // namespace slipproof
