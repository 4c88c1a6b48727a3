// Several papers that were judged in one go: a line for each, and what was found in it.
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

/// The worst of all.
Summary summary(const std::vector<JudgedPaper>& papers);

/// For each paper how its claims stand as printed, and what was found; what is not as it should be, claim by claim.
Document papers_document(const std::vector<JudgedPaper>& papers);
/// One JSON document, schema slipproof/papers/1.
std::string papers_json(const std::vector<JudgedPaper>& papers);

}  // namespace slipproof
