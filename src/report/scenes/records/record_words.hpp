// What was found about records, in words for a terminal.
#pragma once

#include <string>
#include <string_view>

namespace slipproof {

/// The lines of JSON that `certify` writes, each as sentences in lines of at most 80 columns: the verdict, why, which
/// motions or solutions there are, and which --tolerance would accept an inaccurate answer. Takes complete lines.
std::string record_words(std::string_view lines, bool colours = false);

/// The advice for an answer with an error above the tolerance, a bound in digits: `1.3e-5`.
std::string tolerance_advice(const std::string& error);

}  // namespace slipproof
