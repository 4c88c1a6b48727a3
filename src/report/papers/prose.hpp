// Sentences about a paper, with its symbols typeset.
#pragma once

#include <string>

#include "claims/paper/claims_file.hpp"
#include "report/document/document.hpp"

namespace slipproof {

/// Adds a text with formulas in the form of claims files, `xi1 = F0`. Their symbols are typeset.
void add_prose(const Element& parent, const ClaimsFile& claims, const std::string& text);
/// The same as a span, which may be written only while the claims file exists.
ReportSpan prose(const ClaimsFile& claims, const std::string& text);

}  // namespace slipproof
