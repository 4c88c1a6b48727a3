#include "report/html/sections.hpp"
#include "report/markup/latex.hpp"
#include "report/markup/mathml.hpp"
#include "report/papers/errata.hpp"

namespace slipproof {

namespace {

void add_item(const Element& list, std::string_view term, const std::string& text) {
  if (text.empty()) return;
  list.add("dt").text(term);
  add_sentence(list.add("dd"), text);
}

void add_text(const Element& list, const PageInput& input, std::string_view term, const std::string& text) {
  if (text.empty()) return;
  list.add("dt").text(term);
  add_prose(list.add("dd"), input, sentence(text));
}

/// Adds the printed or the intended text, typeset.
void add_parts(const Element& list, std::string_view term, const FindingParts& parts) {
  if (parts.empty()) return;
  list.add("dt").text(term);
  const Element item = list.add("dd");
  for (const FindingPart& part : parts) {
    const Element line = item.add("div", "part");
    if (part.defines) {
      add_definition(line, part.key, part.expression);
      continue;
    }
    line.add("span", "key-word").text(part.key + ": ");
    if (part.expression) {
      add_math(line, part.expression);
    } else {
      line.text(part.text);
    }
  }
}

}  // namespace

void add_errata_section(const Element& main, const PageInput& input) {
  const Element section = add_section(main, "errata", "Errata");
  const Errata errata = slipproof::errata(*input.claims, *input.result);
  if (errata.findings.empty()) {
    section.add("p", "lead").text("There is no finding. " + standing_text(errata));
    return;
  }
  section.add("p", "lead")
      .text("What is wrong in print, in the order of the lines of " + input.claims->paper.source +
            ": a list that can be sent to the authors. " + sum_text(errata));
  const Element list = section.add("ol", "findings");
  for (const Finding& finding : errata.findings) {
    const Element item = list.add("li", "finding").set("id", "finding-" + finding.id);
    const Element heading = item.add("h3");
    heading.text(input.claims->paper.where(finding.line) + ", ");
    add_claim_id(heading, input, finding.id);
    heading.text(" ");
    heading.add("span", "grade " + std::string(name(finding.grade))).text(grade_text(finding));
    const Element facts = item.add("dl");
    add_item(facts, "statement", finding.statement);
    add_parts(facts, "printed", finding.printed);
    add_text(facts, input, "what is wrong", finding.wrong);
    add_parts(facts, "repair", finding.repair);
    add_text(facts, input, "why", finding.why);
    std::string sure = "the error: " + error_certainty(finding);
    if (!finding.repair.empty()) sure += "; the repair: " + repair_certainty(finding);
    add_item(facts, "how sure", sure);
  }
  const Element copy = section.add("details", "data copy");
  copy.add("summary").text("As Markdown, to copy");
  copy.add("pre").set("tabindex", 0).add("code").text(errata_markdown(*input.claims, errata));
}

}  // namespace slipproof
