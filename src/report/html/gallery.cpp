#include "report/html/gallery.hpp"

#include <algorithm>

#include "base/number/format.hpp"
#include "base/output/listed.hpp"
#include "report/html/headline.hpp"
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
  if (!paper.file.paper.reference.empty()) {
    const Element p = item.add("p", "authors");
    p.text(listed(paper.file.paper.authors) + ", ");
    add_reference(p, paper.file.paper.reference);
  }
  if (const ClaimResult* worst = worst_refuted(paper.file, paper.result)) {
    add_worst_motions(item.add("div", "thumbnail"), *worst);
  }
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

std::string gallery_html(const std::vector<JudgedPaper>& papers, const std::string& version, const std::string& image) {
  PageFrame frame{"slipproof: " + counted(papers.size(), "source") + " about dry friction, judged",
                  version,
                  {},
                  "Made by slipproof " + version + ". Each page tells how to make it again."};
  frame.skip = "#papers", frame.skip_words = "Skip to the sources";
  frame.description =
      "Published formulas about dry friction, each proved for all parameters or refuted by numbers to check by hand.";
  frame.image = image;
  // Papers that were published come first; other sources are what textbooks share.
  std::vector<const JudgedPaper*> order;
  for (const JudgedPaper& paper : papers) order.push_back(&paper);
  std::stable_partition(order.begin(), order.end(),
                        [](const JudgedPaper* paper) { return !paper->file.paper.reference.empty(); });
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
                    counted(papers.size(), "source") + ", " + counted(all.claims, "claim") + " as printed",
                    all.printed);
    const Element list = main.add("ul", "papers").set("id", "papers");
    for (const JudgedPaper* paper : order) add_paper(list, *paper);
  });
}

}  // namespace slipproof
