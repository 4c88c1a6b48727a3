#include "report/papers/papers_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number/format.hpp"
#include "report/papers/errata.hpp"
#include "report/papers/explain.hpp"
#include "report/papers/papers_json.hpp"
#include "report/papers/second_checker.hpp"

namespace slipproof {

namespace {

void write_unexpected(Document& document, const JudgedPaper& paper) {
  for (const ClaimResult& claim : paper.result.claims) {
    const Claim& stated = paper.file.claims[claim.claim];
    const std::string& id = stated.id;
    for (const std::string& objection : claim.rejections) document.line(id + " certificate rejected: " + objection);
    if (as_expected(paper.file, claim)) continue;
    const std::string why = explain(paper.file, claim);
    document.line(fmt::format("{} ({}) {}, unexpected{}{}", id, stated.reading_name(claim.reading), name(claim.verdict),
                              why.empty() ? "" : ": ", why));
  }
}

Json paper_json(const JudgedPaper& paper) {
  const Errata list = errata(paper.file, paper.result);
  const Standing& standing = list.standing;
  Json findings = Json::array();
  for (const Finding& f : list.findings) {
    findings.push_back({{"id", f.id},
                        {"origin", name(f.origin)},
                        {"grade", name(f.grade)},
                        {"statement", f.statement},
                        {"wrong", f.wrong}});
  }
  Json entry;
  entry["name"] = paper.name;
  entry["title"] = paper.file.paper.title;
  entry["found"] = paper.file.paper.found;
  put_counts(entry, "claims", standing.claims.all());
  put_origins(entry, "claims", standing.claims);
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

namespace {

/// `328 as printed: proved 253 hold 0 refuted 64 open 11`.
std::string status_counts(const ClaimCounts& t, std::string_view whose) {
  return fmt::format("{} {}: proved {} hold {} refuted {} open {}", t.judged, whose, t.proved, t.held, t.refuted,
                     t.open());
}

/// A row for the claims as printed and one for our own. Returns what is below them.
Document& add_rows(ReportTable& table, const std::string& paper, const CountsByOrigin& counts) {
  Document* below = nullptr;
  for (const Origin origin : all_origins) {
    const ClaimCounts& t = counts[origin];
    if (t.judged == 0 && (origin == Origin::ours || counts.ours.judged > 0)) continue;
    below = &table.row({below == nullptr ? paper : "", name(origin), ReportCell::count(t.judged),
                        ReportCell::count(t.proved), ReportCell::count(t.held), ReportCell::count(t.refuted),
                        ReportCell::count(t.open())});
  }
  return *below;
}

}  // namespace

Document papers_document(const std::vector<JudgedPaper>& papers) {
  Document document;
  document.paragraph(
      "What is printed about dry friction, held against the equations of motion, and what is our own beside it. "
      "proved: true of all parameters, with a certificate; holds: at every sample; refuted: false, with numbers to "
      "check by hand; open: neither.");
  ReportTable& table = document.table({{{"paper", false, 26},
                                        {"origin", false, 7},
                                        {"claims", true},
                                        {"proved", true},
                                        {"holds", true, 6},
                                        {"refuted", true},
                                        {"open", true, 5}}});
  CountsByOrigin all;
  std::size_t missing = 0, findings = 0;
  for (const JudgedPaper& paper : papers) {
    const Errata list = errata(paper.file, paper.result);
    const Standing& standing = list.standing;
    for (const Origin origin : all_origins) all[origin].add(standing.claims[origin]);
    missing += standing.missing;
    findings += list.findings.size();
    Document& below = add_rows(table, paper.name, standing.claims);
    below.paragraph(paper.file.paper.found);
    if (standing.missing > 0) below.paragraph(missing_text(standing.missing));
    write_unexpected(below, paper);
  }
  if (const auto second = second_checker(papers)) document.paragraph(in_words(*second) + ".", 2);
  document.status(fmt::format("s {} {}, {}, {}, {}{}", summary_word(summary(papers)), counted(papers.size(), "source"),
                              status_counts(all.printed, "as printed"), status_counts(all.ours, "of our own"),
                              counted(findings, "finding"), missing == 0 ? "" : fmt::format(", {} missing", missing)));
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
