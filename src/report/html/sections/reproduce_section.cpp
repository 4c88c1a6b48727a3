#include "base/number/format.hpp"
#include "base/output/listed.hpp"
#include "report/html/headline.hpp"
#include "report/html/sections.hpp"

namespace slipproof {

namespace {

/// How to cite this report and the paper. The inputs and the version determine every byte of the page.
void add_citation(const Element& section, const PageInput& input) {
  const Paper& paper = input.claims->paper;
  const std::string authors = listed(paper.authors);
  section.add("h3").text("How to cite");
  const Element p = section.add("p");
  p.text("The " + std::string(kind_of_source(*input.claims)) + ": " + authors + (authors.empty() ? "" : ", "))
      .add("i")
      .text(paper.title);
  p.text((paper.reference.empty() ? "" : ", " + paper.reference) + ". Line numbers are those of " + paper.source + ".");
  section.add("p").text("This report: “slipproof " + input.version + ", report on ‘" + paper.title + "’, seed " +
                        std::to_string(input.result->seed) + ", " + std::to_string(input.result->samples) +
                        " samples”, together with the SHA-256 of the claims file below.");
  section.add("p").text(
      "One verdict: the id of the claim, its reading (printed, ours or repaired), and the verdict; a "
      "counterexample, as the scene that can be downloaded beside it.");
}

}  // namespace

void add_reproduce_section(const Element& main, const PageInput& input) {
  const Element section = add_section(main, "reproduce", "Reproduce");
  section.add("p", "lead")
      .text(
          "The same inputs, seed and version give the same bytes of this page, on any machine and "
          "at any number of threads.");
  Document facts;
  facts.verbatim(input.command);
  facts.fact("version", "slipproof " + input.version);
  facts.fact("seed", std::to_string(input.result->seed));
  facts.fact("samples of each setting", std::to_string(input.result->samples));
  add_document(section, facts);
  add_citation(section, input);
  if (input.sources.empty()) return;
  Document sources;
  ReportTable& table =
      sources.details("SHA-256 of the " + counted(input.sources.size(), "input")).table({{"file", "SHA-256"}});
  table.label = "Inputs";
  table.css_class = "inputs";
  for (const PageSource& source : input.sources) table.row({source.name, code(source.sha256)});
  add_document(section, sources);
}

}  // namespace slipproof
