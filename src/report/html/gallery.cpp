#include "report/html/gallery.hpp"

#include <algorithm>

#include "base/number/format.hpp"
#include "base/output/listed.hpp"
#include "report/html/headline.hpp"
#include "report/html/sections.hpp"
#include "report/html/verdict_bar.hpp"
#include "report/papers/claim_counts.hpp"
#include "report/papers/errata.hpp"
#include "report/papers/second_checker.hpp"

namespace slipproof {

namespace {

VerdictTotals total(const std::vector<JudgedPaper>& papers) {
  VerdictTotals all;
  for (const JudgedPaper& paper : papers) all.add(count_verdicts(paper.file, paper.result));
  return all;
}

/// A bar for what is printed and one for what is our own.
void add_bars(const Element& parent, const VerdictTotals& counts) {
  add_verdict_bar(parent, counted(sum(counts.printed), "claim") + " as printed", counts.printed);
  add_verdict_bar(parent, counted(sum(counts.ours), "claim") + " of our own", counts.ours);
}

void add_paper(const Element& list, const JudgedPaper& paper) {
  const std::size_t findings = errata(paper.file, paper.result).findings.size();
  const Element item = list.add("li", findings > 0 ? "paper item with-findings" : "paper item");
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
  add_bars(item, count_verdicts(paper.file, paper.result));
  if (findings > 0) {
    item.add("p").add("a").set("href", page_name(paper) + "#errata").text(counted(findings, "finding"));
  }
  if (summary(paper.file, paper.result) != Summary::as_expected) {
    item.add("p", "because").text("Not every verdict is the one that the claims file expects.");
  }
}

/// Which sources are shown; works without a script.
void add_choice(const Element& section) {
  const Element choice = section.add("fieldset", "filter");
  choice.add("legend").text("Show");
  const auto option = [&](const char* id, const char* words) {
    const Element label = choice.add("label");
    const Element input = label.add("input").set("type", "radio").set("name", "show").set("id", id);
    label.text(std::string(" ") + words);
    return input;
  };
  option("all-sources", "all sources").set("checked", "checked");
  option("only-findings", "with findings");
  option("no-findings", "without findings");
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
  frame.script = search_script;
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
    const Element bars = overview.add("div", "bars");
    bars.add("p").add("b").text(counted(papers.size(), "source") + ", " + claims_text(sum(all.printed), sum(all.ours)));
    add_bars(bars, all);
    const Element section = main.add("section").set("aria-labelledby", "sources-heading");
    section.add("h2").set("id", "sources-heading").text("Sources");
    add_search(section, "papers", "Filter the sources: words of titles, authors, findings");
    add_choice(section);
    const Element list = section.add("ul", "papers").set("id", "papers");
    for (const JudgedPaper* paper : order) add_paper(list, *paper);
  });
}

}  // namespace slipproof
