#include "report/html/verdict_bar.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include "report/html/sections.hpp"
#include "report/markup/number.hpp"

namespace slipproof {

std::size_t sum(const VerdictCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

void VerdictTotals::add(const VerdictTotals& other) {
  for (const auto counts : {&VerdictTotals::printed, &VerdictTotals::ours, &VerdictTotals::repaired}) {
    for (std::size_t i = 0; i < claim_verdicts.size(); ++i) (this->*counts)[i] += (other.*counts)[i];
  }
}

VerdictTotals count_verdicts(const ClaimsFile& file, const VerifyResult& result) {
  VerdictTotals counts;
  for (const ClaimResult& claim : result.claims) {
    const auto at =
        std::find(claim_verdicts.begin(), claim_verdicts.end(), verdict_name(claim)) - claim_verdicts.begin();
    const bool ours = file.claims[claim.claim].origin == Origin::ours;
    VerdictCounts& here = claim.reading == Reading::repaired ? counts.repaired : ours ? counts.ours : counts.printed;
    ++here[static_cast<std::size_t>(at)];
  }
  return counts;
}

void add_bar(const Element& parent, const std::vector<BarPart>& parts, double width, double height) {
  const Element svg =
      parent.add("svg", "bar").set("viewBox", "0 0 " + short_number(width) + " " + short_number(height));
  svg.set("preserveAspectRatio", "none").set("aria-hidden", "true");
  double all = 0, x = 0;
  for (const BarPart& part : parts) all += static_cast<double>(part.count);
  for (const BarPart& part : parts) {
    if (part.count == 0) continue;
    const double share = width * static_cast<double>(part.count) / all;
    svg.add("rect", part.css_class).set("x", x).set("width", share).set("height", height);
    x += share;
  }
}

void add_verdict_bar(const Element& parent, std::string_view label, const VerdictCounts& counts) {
  if (sum(counts) == 0) return;
  const Element row = parent.add("div", "bar-row");
  row.add("span", "bar-label").text(label);
  std::vector<BarPart> parts;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    parts.push_back({"fill-" + std::string(claim_verdicts[i]), counts[i]});
  }
  add_bar(row, parts, 600, 22);
  const Element text = row.add("span", "bar-text");
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    const Element item = text.add("span", "bar-item");
    add_chip(item, claim_verdicts[i]);
    item.text(" " + std::to_string(counts[i]));
  }
}

}  // namespace slipproof
