#include <algorithm>

#include "base/output/listed.hpp"
#include "report/papers/errata.hpp"

namespace slipproof {

std::vector<std::string> uncovered_equations(const ClaimsFile& file) {
  std::vector<std::string> missing;
  for (const auto& equation : file.paper.equations) {
    if (std::none_of(file.claims.begin(), file.claims.end(),
                     [&](const Claim& claim) { return claim.equation == equation.number; })) {
      missing.push_back(equation.number);
    }
  }
  return missing;
}

Document coverage_document(const ClaimsFile& file) {
  Document document;
  ReportTable& table = document.table({{"equation", "line", "claims"}});
  for (const auto& equation : file.paper.equations) {
    std::vector<std::string> ids;
    for (const Claim& claim : file.claims) {
      if (claim.equation == equation.number) ids.push_back(claim.id);
    }
    table.row({"(" + equation.number + ")", std::to_string(equation.line), listed(ids)});
  }
  for (const Unchecked& u : file.unchecked) table.row({u.id, std::to_string(u.line), "not judged: " + u.why});
  return document;
}

}  // namespace slipproof
