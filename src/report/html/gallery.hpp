// One page for several papers: what was found in each, and where its own page is.
#pragma once

#include <string>
#include <vector>

#include "report/papers/papers_report.hpp"

namespace slipproof {

/// The name of a paper's own page, beside that of all papers.
std::string page_name(const JudgedPaper& paper);

/// The page, HTML 5, without a script. The same input gives the same bytes.
std::string gallery_html(const std::vector<JudgedPaper>& papers, const std::string& version);

}  // namespace slipproof
