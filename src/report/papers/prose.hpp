// Sentences about a paper, with its symbols typeset.
#pragma once

#include <string>

#include "claims/paper/claims_file.hpp"
#include "report/document/document.hpp"

namespace slipproof {

/// A text with formulas as claims files write them, `xi1 = F0`: their symbols are typeset.
void add_prose(const Element& parent, const ClaimsFile& claims, const std::string& text);
/// The same as a part of a document that is written as long as the claims file is there; nothing of no text.
ReportSpan prose(const ClaimsFile& claims, const std::string& text);

}  // namespace slipproof
