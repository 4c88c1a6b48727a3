#include "report/html/sections.hpp"
#include "report/papers/errata.hpp"

namespace slipproof {

void add_errata_section(const Element& main, const PageInput& input) {
  const Element section = add_section(main, "errata", "Errata");
  const Errata errata = slipproof::errata(*input.claims, *input.result);
  if (errata.findings.empty()) {
    section.add("p", "lead").text("There is no finding. " + standing_text(errata));
    return;
  }
  section.add("p", "lead")
      .text("What is wrong, in the order of the lines of " + input.claims->paper.source +
            (input.claims->paper.reference.empty() ? ". " : ": a list that can be sent to the authors. ") +
            sum_text(errata));
  const Element list = section.add("ol", "findings");
  for (const Finding& finding : errata.findings) {
    const Element item = list.add("li", "finding").set("id", "finding-" + finding.id);
    add_line(item.add("h3"), finding_heading(*input.claims, finding));
    add_document(item, finding_document(*input.claims, finding));
  }
  const Element copy = section.add("details", "data copy");
  copy.add("summary").text("As Markdown, to copy");
  copy.add("pre").set("tabindex", 0).add("code").text(markdown_of(errata_document(*input.claims, errata)));
}

}  // namespace slipproof
