// How answers of engines and their verdicts are written in tables.
#pragma once

#include <string>
#include <string_view>

#include "report/document/document.hpp"
#include "report/engines/engine_table.hpp"
#include "report/markup/element.hpp"

namespace slipproof {

/// `1.2e-05`.
std::string error_text(double error);

/// `31 of 40`: how many are right of those that were not refused; a dash if all were.
std::string share_text(const EngineCounts& counts);

/// The cell, with the words that the numbers of an engine with such a design need.
ReportCell by_design(ReportCell cell);

/// Words in the colour of a verdict and with its sign.
void add_verdict(const Element& parent, EngineVerdict verdict, std::string_view words);

/// Only its sign, in its colour.
void add_sign(const Element& parent, EngineVerdict verdict);
/// `wrong, 2.1e-01`: the verdict, and the error of an answer that is not right.
std::string verdict_words(const JudgedEngineAnswer& one);

/// The verdict, or the error of an answer that is not right; a link, unless `href` is empty.
ReportCell verdict_cell(const JudgedEngineAnswer& one, const std::string& href);

/// The accelerations, the threshold with the floor above which it was found, or why there is neither.
std::string answer_text(const EngineAnswer& answer);

/// Of an impact `; right by newton, moreau; energy -25 %`; empty otherwise.
std::string impact_text(const JudgedEngineAnswer& one);

}  // namespace slipproof
