#include <iterator>
#include <string>

#include "report/html/headline.hpp"
#include "report/html/sections.hpp"
#include "report/html/verdict_bar.hpp"
#include "report/papers/explain.hpp"

namespace slipproof {

namespace {

/// The part of the paper that contains a claim, by the paper's headings; empty without them.
std::string part_of(const Paper& paper, const Claim& claim) {
  const auto next = paper.headings.upper_bound(claim.line);
  return next == paper.headings.begin() ? "" : std::prev(next)->second;
}

void add_filter(const Element& section, bool both_origins) {
  const Element filter = section.add("fieldset", "filter");
  filter.add("legend").text("Show");
  const auto option = [&](const char* id, const char* text, bool checked = false) {
    const Element label = filter.add("label");
    const Element input = label.add("input").set("type", "radio").set("name", "show").set("id", id);
    if (checked) input.set("checked", "checked");
    label.text(std::string(" ") + text);
  };
  option("show-all", "all claims", true);
  if (both_origins) {
    option("show-printed", "as printed");
    option("show-ours", "our own");
  }
  option("show-failing", "refuted, undecided or vacuous");
  option("show-proved", "proved for all parameters");
}

/// What the list contains.
std::string contents(const ClaimsFile& file, const VerdictTotals& counts) {
  std::string text;
  if (sum(counts.printed) > 0) {
    text = "Every statement of the " + std::string(kind_of_source(file)) + " that a calculation can judge, as printed" +
           (sum(counts.repaired) > 0 ? " and, where the print cannot be meant, as repaired. " : ". ");
  }
  if (sum(counts.ours) > 0) text += text.empty() ? "Claims of our own. " : "Beside them are claims of our own. ";
  return text;
}

}  // namespace

void add_claims_section(const Element& main, const PageInput& input) {
  const VerdictTotals counts = count_verdicts(*input.claims, *input.result);
  const Element section = add_section(main, "claims", "Claims");
  section.add("p", "lead")
      .text(contents(*input.claims, counts) + "Proved: for all parameters. Holds: at every sampled " +
            std::string(noun(*input.claims)) +
            ", for every force. Refuted: false, with the simplest counterexample found.");
  add_filter(section, sum(counts.printed) > 0 && sum(counts.ours) > 0);
  std::string part;
  std::size_t last = input.claims->claims.size();
  for (const ClaimResult& result : input.result->claims) {
    if (result.claim == last) continue;
    last = result.claim;
    const std::string here = part_of(input.claims->paper, input.claims->claims[result.claim]);
    if (here != part && !here.empty()) section.add("h3").text(here);
    part = here;
    add_claim_card(section, input, result.claim);
  }
  if (input.claims->unchecked.empty()) return;
  section.add("h3").text("Not judged");
  const Element list = section.add("ul");
  for (const Unchecked& statement : input.claims->unchecked) {
    list.add("li").text(statement.id + ", line " + std::to_string(statement.line) + ": " + statement.statement + " (" +
                        statement.why + ")");
  }
}

}  // namespace slipproof
