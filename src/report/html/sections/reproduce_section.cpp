#include "base/number/format.hpp"
#include "report/html/sections.hpp"

namespace slipproof {

namespace {

/// How to cite this report and the paper. The inputs and the version determine every byte of the page.
void add_citation(const Element& section, const PageInput& input) {
  const Paper& paper = input.claims->paper;
  std::string authors;
  for (const std::string& author : paper.authors) authors += (authors.empty() ? "" : ", ") + author;
  section.add("h3").text("How to cite");
  const Element p = section.add("p");
  p.text("The paper: " + authors + (authors.empty() ? "" : ", ")).add("i").text(paper.title);
  p.text((paper.reference.empty() ? "" : ", " + paper.reference) + ". Line numbers are those of its source text, " +
         paper.source + ".");
  section.add("p").text("This report: “slipproof " + input.version + ", report on ‘" + paper.title + "’, seed " +
                        std::to_string(input.result->seed) + ", " + std::to_string(input.result->samples) +
                        " samples”, together with the SHA-256 of the claims file below.");
  section.add("p").text(
      "One verdict: the id of the claim, its reading (printed or repaired), and the verdict; a "
      "counterexample, as the scene that can be downloaded beside it.");
}

}  // namespace

void add_reproduce_section(const Element& main, const PageInput& input) {
  const Element section = add_section(main, "reproduce", "Reproduce");
  section.add("p", "lead")
      .text(
          "The same inputs, seed and version give the same bytes of this page, on any machine and "
          "at any number of threads.");
  section.add("pre").set("tabindex", 0).add("code").text(input.command);
  const Element facts = section.add("dl");
  const auto fact = [&](std::string_view term, const std::string& value) {
    facts.add("dt").text(term);
    facts.add("dd").text(value);
  };
  fact("version", "slipproof " + input.version);
  fact("seed", std::to_string(input.result->seed));
  fact("samples of each setting", std::to_string(input.result->samples));
  add_citation(section, input);
  if (input.sources.empty()) return;
  const Element details = section.add("details", "data");
  details.add("summary").text("SHA-256 of the " + counted(input.sources.size(), "input"));
  const Element scroll = details.add("div", "scroll").set("tabindex", 0).set("role", "region");
  scroll.set("aria-label", "Inputs");
  const Element table = scroll.add("table", "inputs");
  const Element head = table.add("thead").add("tr");
  head.add("th").set("scope", "col").text("file");
  head.add("th").set("scope", "col").text("SHA-256");
  const Element body = table.add("tbody");
  for (const PageSource& source : input.sources) {
    const Element row = body.add("tr");
    row.add("th").set("scope", "row").text(source.name);
    row.add("td").add("code").text(source.sha256);
  }
}

}  // namespace slipproof
