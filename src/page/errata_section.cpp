#include "page/sections.hpp"
#include "report/errata.hpp"
#include "typeset/latex.hpp"

namespace slipproof {

namespace {

void add_item(const Element& list, std::string_view term, const std::string& text, bool code) {
  if (text.empty()) return;
  list.add("dt").text(term);
  const Element item = list.add("dd");
  if (code) {
    item.add("code").text(text);
  } else {
    add_sentence(item, text);
  }
}

}  // namespace

void add_errata_section(const Element& main, const PageInput& input) {
  const Element section = add_section(main, "errata", "Errata");
  const auto findings = errata(*input.claims, *input.result);
  if (findings.empty()) {
    section.add("p", "lead").text("Nothing was found to be wrong with the paper.");
    return;
  }
  section.add("p", "lead")
      .text("What is wrong in print, in the order of the lines of " + input.claims->paper.source +
            ": a list that can be sent to the authors.");
  const Element list = section.add("ol", "findings");
  for (const Finding& finding : findings) {
    const Element item = list.add("li", "finding");
    const Element heading = item.add("h3");
    heading.text("Line " + std::to_string(finding.line) + ", ");
    add_claim_id(heading, input, finding.id);
    heading.text(" ");
    heading.add("span", "grade " + std::string(name(finding.grade))).text(name(finding.grade));
    const Element facts = item.add("dl");
    add_item(facts, "statement", finding.statement, false);
    add_item(facts, "printed", finding.printed, true);
    add_item(facts, "what is wrong", finding.wrong, false);
    add_item(facts, "repair", finding.repair, true);
    add_item(facts, "why", finding.why, false);
    std::string sure = "error: " + error_certainty(finding);
    if (!finding.repair.empty()) sure += "; repair: " + repair_certainty(finding);
    add_item(facts, "how sure", sure, false);
  }
  const Element copy = section.add("details", "data copy");
  copy.add("summary").text("As Markdown, to copy");
  copy.add("pre").set("tabindex", 0).add("code").text(errata_markdown(*input.claims, findings));
}

}  // namespace slipproof
