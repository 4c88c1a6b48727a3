// The report on several papers judged together: one line for each, and its findings.
#pragma once

#include <string>
#include <vector>

#include "claims/verify/verify.hpp"
#include "report/papers/verify_report.hpp"

namespace slipproof {

struct JudgedPaper {
  std::string name;  ///< of its folder
  ClaimsFile file;
  VerifyResult result;
};

/// The worst result of all papers.
Summary summary(const std::vector<JudgedPaper>& papers);

/// How the claims of each paper stand, as printed and of our own, and what was found; then each claim with an
/// unexpected verdict.
Document papers_document(const std::vector<JudgedPaper>& papers);
/// One JSON document, schema slipproof/papers/1.
std::string papers_json(const std::vector<JudgedPaper>& papers);

}  // namespace slipproof
