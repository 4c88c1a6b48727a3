#include "html/verdict_bar.hpp"

#include <algorithm>
#include <string>

#include "html/sections.hpp"

namespace slipproof {

VerdictTotals count_verdicts(const VerifyResult& result) {
  VerdictTotals counts;
  for (const ClaimResult& claim : result.claims) {
    const auto at =
        std::find(claim_verdicts.begin(), claim_verdicts.end(), verdict_name(claim)) - claim_verdicts.begin();
    if (claim.reading == Reading::printed) {
      ++counts.claims;
      ++counts.printed[static_cast<std::size_t>(at)];
    } else {
      ++counts.repaired[static_cast<std::size_t>(at)];
    }
  }
  return counts;
}

void add_verdict_bar(const Element& parent, std::string_view label, const VerdictCounts& counts) {
  std::size_t all = 0;
  for (const std::size_t n : counts) all += n;
  if (all == 0) return;
  const Element row = parent.add("div", "bar-row");
  row.add("span", "bar-label").text(label);
  const Element svg = row.add("svg", "bar").set("viewBox", "0 0 600 22").set("preserveAspectRatio", "none");
  svg.set("aria-hidden", "true");
  double x = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double width = 600.0 * static_cast<double>(counts[i]) / static_cast<double>(all);
    if (counts[i] == 0) continue;
    svg.add("rect", "fill-" + std::string(claim_verdicts[i])).set("x", x).set("width", width).set("height", 22);
    x += width;
  }
  const Element text = row.add("span", "bar-text");
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    const Element item = text.add("span", "bar-item");
    add_chip(item, claim_verdicts[i]);
    item.text(" " + std::to_string(counts[i]));
  }
}

}  // namespace slipproof
