#include <algorithm>

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

std::string coverage_markdown(const ClaimsFile& file) {
  std::string text = "| equation | line | claims |\n|---|---|---|\n";
  for (const auto& equation : file.paper.equations) {
    std::string ids;
    for (const Claim& claim : file.claims) {
      if (claim.equation == equation.number) ids += (ids.empty() ? "" : ", ") + claim.id;
    }
    text += "| (" + equation.number + ") | " + std::to_string(equation.line) + " | " + ids + " |\n";
  }
  for (const Unchecked& u : file.unchecked) {
    text += "| " + u.id + " | " + std::to_string(u.line) + " | not judged: " + u.why + " |\n";
  }
  return text;
}

}  // namespace slipproof
