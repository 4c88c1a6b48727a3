#include <cctype>
#include <iterator>
#include <string>

#include "report/html/sections.hpp"
#include "report/papers/explain.hpp"

namespace slipproof {

namespace {

/// The part of the paper that contains a claim, by the paper's headings; without headings, by its id.
std::string part_of(const Paper& paper, const Claim& claim) {
  const auto next = paper.headings.upper_bound(claim.line);
  if (next != paper.headings.begin()) return std::prev(next)->second;
  std::size_t end = 1;
  while (end < claim.id.size() && std::isdigit(static_cast<unsigned char>(claim.id[end])) != 0) ++end;
  const std::string number = claim.id.substr(1, end - 1);
  if (number.empty()) return "Other claims";
  return (claim.id[0] == 'A' ? "Assertion " : "Section ") + number;
}

void add_filter(const Element& section) {
  const Element filter = section.add("fieldset", "filter");
  filter.add("legend").text("Show");
  const auto option = [&](const char* id, const char* text, bool checked) {
    const Element label = filter.add("label");
    const Element input = label.add("input").set("type", "radio").set("name", "show").set("id", id);
    if (checked) input.set("checked", "checked");
    label.text(std::string(" ") + text);
  };
  option("show-all", "all claims", true);
  option("show-failing", "refuted or without a value as printed", false);
  option("show-proved", "proved for all parameters", false);
}

}  // namespace

void add_claims_section(const Element& main, const PageInput& input) {
  const Element section = add_section(main, "claims", "Claims");
  section.add("p", "lead")
      .text(
          "Every statement of the paper that a calculation can judge, in the order of its lines, as "
          "printed and, where the print cannot be meant, as repaired. Proved: for all parameters. Holds: "
          "at every sampled " +
          std::string(noun(*input.claims)) +
          ", for every force. Refuted: false, with the simplest counterexample found.");
  add_filter(section);
  std::string part;
  std::size_t last = input.claims->claims.size();
  for (const ClaimResult& result : input.result->claims) {
    if (result.claim == last) continue;
    last = result.claim;
    const std::string here = part_of(input.claims->paper, input.claims->claims[result.claim]);
    if (here != part) section.add("h3").text(here);
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
