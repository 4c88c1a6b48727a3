#include "report/papers/papers_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number/format.hpp"
#include "report/papers/errata.hpp"
#include "report/papers/explain.hpp"
#include "report/papers/second_checker.hpp"
#include "report/papers/second_checker_json.hpp"
#include "report/values/exact_json.hpp"

namespace slipproof {

namespace {

std::size_t open_claims(const Standing& standing) {
  return standing.undecided.size() + standing.vacuous.size();
}

void write_unexpected(Document& document, const JudgedPaper& paper) {
  for (const ClaimResult& claim : paper.result.claims) {
    const std::string id = paper.file.claims[claim.claim].id;
    for (const std::string& objection : claim.rejections) document.line(id + " certificate rejected: " + objection);
    if (as_expected(paper.file, claim)) continue;
    const std::string why = explain(paper.file, claim);
    document.line(fmt::format("{} ({}) {}, unexpected{}{}", id, name(claim.reading), name(claim.verdict),
                              why.empty() ? "" : ": ", why));
  }
}

Json paper_json(const JudgedPaper& paper) {
  const Errata list = errata(paper.file, paper.result);
  const Standing& standing = list.standing;
  Json findings = Json::array();
  for (const Finding& f : list.findings) {
    findings.push_back({{"id", f.id}, {"grade", name(f.grade)}, {"statement", f.statement}, {"wrong", f.wrong}});
  }
  Json entry;
  entry["name"] = paper.name;
  entry["title"] = paper.file.paper.title;
  entry["found"] = paper.file.paper.found;
  entry["claims"] = standing.judged;
  entry["proved"] = standing.proved;
  entry["holds"] = standing.held;
  entry["refuted"] = standing.refuted;
  entry["undecided"] = standing.undecided;
  entry["vacuous"] = standing.vacuous;
  entry["missing"] = standing.missing;
  entry["as_expected"] = summary(paper.file, paper.result) == Summary::as_expected;
  entry["findings"] = std::move(findings);
  if (paper.result.second_checker) entry["second_checker"] = to_json(*paper.result.second_checker);
  return entry;
}

}  // namespace

Summary summary(const std::vector<JudgedPaper>& papers) {
  constexpr std::array<Summary, 4> worst_first{Summary::rejected, Summary::refuted, Summary::undecided,
                                               Summary::as_expected};
  std::vector<Summary> all;
  for (const JudgedPaper& paper : papers) all.push_back(summary(paper.file, paper.result));
  const auto worst = std::find_if(worst_first.begin(), worst_first.end(),
                                  [&](Summary s) { return std::find(all.begin(), all.end(), s) != all.end(); });
  return worst == worst_first.end() ? Summary::undecided : *worst;
}

Document papers_document(const std::vector<JudgedPaper>& papers) {
  Document document;
  document.paragraph(
      "What is printed about dry friction, held against the equations of motion. proved: true of all parameters, with "
      "a certificate; holds: at every sample; refuted: false, with numbers to check by hand; open: neither.");
  ReportTable& table = document.table({{{"paper", false, 28},
                                        {"claims", true},
                                        {"proved", true},
                                        {"holds", true, 6},
                                        {"refuted", true},
                                        {"open", true, 5}}});
  Standing all;
  std::size_t open = 0, findings = 0;
  for (const JudgedPaper& paper : papers) {
    const Errata list = errata(paper.file, paper.result);
    const Standing& standing = list.standing;
    all.proved += standing.proved;
    all.held += standing.held;
    all.refuted += standing.refuted;
    open += open_claims(standing);
    all.missing += standing.missing;
    findings += list.findings.size();
    Document& below = table.row({paper.name, ReportCell::count(standing.judged), ReportCell::count(standing.proved),
                                 ReportCell::count(standing.held), ReportCell::count(standing.refuted),
                                 ReportCell::count(open_claims(standing))});
    below.paragraph(paper.file.paper.found);
    if (standing.missing > 0) below.paragraph(missing_text(standing.missing));
    write_unexpected(below, paper);
  }
  if (const auto second = second_checker(papers)) document.paragraph(in_words(*second) + ".", 2);
  document.status(fmt::format("s {} {} {} proved {} hold {} refuted {} open, {}{}", summary_word(summary(papers)),
                              counted(papers.size(), "paper"), all.proved, all.held, all.refuted, open,
                              counted(findings, "finding"),
                              all.missing == 0 ? "" : fmt::format(", {} missing", all.missing)));
  return document;
}

std::string papers_json(const std::vector<JudgedPaper>& papers) {
  Json document;
  document["schema"] = "slipproof/papers/1";
  document["papers"] = Json::array();
  for (const JudgedPaper& paper : papers) document["papers"].push_back(paper_json(paper));
  return dump(document);
}

}  // namespace slipproof
