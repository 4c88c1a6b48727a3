#include "report/html/gallery.hpp"

#include "base/number/format.hpp"
#include "report/html/sections.hpp"
#include "report/html/verdict_bar.hpp"
#include "report/papers/errata.hpp"
#include "report/papers/second_checker.hpp"

namespace slipproof {

namespace {

VerdictTotals total(const std::vector<JudgedPaper>& papers) {
  VerdictTotals all;
  for (const JudgedPaper& paper : papers) {
    const VerdictTotals counts = count_verdicts(paper.result);
    all.claims += counts.claims;
    for (std::size_t i = 0; i < claim_verdicts.size(); ++i) {
      all.printed[i] += counts.printed[i];
      all.repaired[i] += counts.repaired[i];
    }
  }
  return all;
}

void add_paper(const Element& list, const JudgedPaper& paper) {
  const Element item = list.add("li", "paper");
  item.add("h2").add("a").set("href", page_name(paper)).text(paper.file.paper.title);
  if (!paper.file.paper.found.empty()) item.add("p", "found").text(paper.file.paper.found);
  const VerdictTotals counts = count_verdicts(paper.result);
  const std::size_t findings = errata(paper.file, paper.result).findings.size();
  add_verdict_bar(
      item, counted(counts.claims, "claim") + " as printed" + (findings > 0 ? ", " + counted(findings, "finding") : ""),
      counts.printed);
  if (summary(paper.file, paper.result) != Summary::as_expected) {
    item.add("p", "because").text("Not every verdict is the one that the claims file expects.");
  }
}

}  // namespace

std::string page_name(const JudgedPaper& paper) {
  return paper.name + ".html";
}

std::string gallery_html(const std::vector<JudgedPaper>& papers, const std::string& version) {
  PageFrame frame{"slipproof: " + counted(papers.size(), "paper"),
                  version,
                  {},
                  "Made by slipproof " + version + ". Each paper's page tells how to make it again."};
  frame.skip = "#papers", frame.skip_words = "Skip to the papers";
  return framed(frame, [&](const Element& main) {
    const Element overview = main.add("section").set("id", "overview").set("aria-labelledby", "title");
    overview.add("h1").set("id", "title").text("What is printed about dry friction, judged");
    overview.add("p").text(
        "Each formula is held against the equations of motion of its mechanism, in exact arithmetic: proved for all "
        "parameters with a certificate that a program of its own checks, or refuted by numbers that a person can "
        "follow. What the formulas leave open is stated and proved beside them.");
    if (const auto second = second_checker(papers)) overview.add("p").text(in_words(*second) + ".");
    const VerdictTotals all = total(papers);
    add_verdict_bar(overview.add("div", "bars"),
                    counted(papers.size(), "paper") + ", " + counted(all.claims, "claim") + " as printed", all.printed);
    const Element list = main.add("ul", "papers").set("id", "papers");
    for (const JudgedPaper& paper : papers) add_paper(list, paper);
  });
}

}  // namespace slipproof
