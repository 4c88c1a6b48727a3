// One page for several papers: what was found in each, with a link to its own page.
#pragma once

#include <string>
#include <vector>

#include "report/papers/papers_report.hpp"

namespace slipproof {

/// The file name of a paper's own page, in the folder of the page of all papers.
std::string page_name(const JudgedPaper& paper);

/// The page as HTML 5, without a script; `image` as in PageFrame. The same input gives the same bytes.
std::string gallery_html(const std::vector<JudgedPaper>& papers, const std::string& version,
                         const std::string& image = {});

}  // namespace slipproof
