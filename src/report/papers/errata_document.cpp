#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/number/format.hpp"
#include "base/output/listed.hpp"
#include "report/markup/latex.hpp"
#include "report/markup/mathml.hpp"
#include "report/papers/errata.hpp"
#include "report/papers/explain.hpp"
#include "report/papers/prose.hpp"

namespace slipproof {

namespace {

/// `certificates A, B`; empty where there are none.
std::string certificates_text(const std::vector<std::string>& certificates) {
  if (certificates.empty()) return {};
  return (certificates.size() == 1 ? "certificate " : "certificates ") + listed(certificates);
}

std::string summary_line(const Errata& errata) {
  std::array<int, 4> counts{};
  for (const Finding& f : errata.findings) ++counts[static_cast<std::size_t>(f.grade)];
  std::string line = counted(errata.findings.size(), "finding");
  for (const Grade grade : {Grade::misprint, Grade::gap, Grade::boundary, Grade::wrong}) {
    line += fmt::format("{}{} {}", grade == Grade::misprint ? ": " : ", ", counts[static_cast<std::size_t>(grade)],
                        name(grade));
  }
  const auto ungraded = static_cast<std::size_t>(
      std::count_if(errata.findings.begin(), errata.findings.end(), [](const Finding& f) { return !f.graded; }));
  return line + (ungraded == 0 ? "" : fmt::format("; no grade is given for {} of them", ungraded));
}

const char* is(std::size_t n) {
  return n == 1 ? "is" : "are";
}

}  // namespace

std::string to_string(const FindingParts& parts) {
  return listed(
      parts, [](const FindingPart& part) { return part.key + (part.defines ? " = " : ": ") + part.text; }, "; ");
}

std::string grade_text(const Finding& finding) {
  return std::string(name(finding.grade)) + (finding.graded ? "" : " (no grade is given)");
}

std::string standing_text(const Errata& errata) {
  const Standing& s = errata.standing;
  const ClaimCounts all = s.claims.all();
  if (all.judged == 0) return "No claim was judged: nothing is known.";
  const std::string text = counts_text(s.claims) + (s.missing == 0 ? "" : " " + missing_text(s.missing) + ".");
  if (!errata.findings.empty()) return text;
  if (all.open() > 0) return text + " No claim is refuted, yet this is no all-clear.";
  return text + (all.held == 0 ? " Nothing is wrong with what was judged."
                               : " Nothing wrong was found; what is not proved was tried at samples only.");
}

std::string sum_text(const Errata& errata) {
  const Standing& s = errata.standing;
  const std::size_t refuted = s.claims.all().refuted, own = refuted - s.shared, all = errata.findings.size();
  if (refuted == 0 || (own == refuted && all == own)) return "";  // the numbers need no explanation
  std::string text = fmt::format("{} {} refuted, and there {} {}. ", counted(refuted, "claim"), is(refuted), is(all),
                                 counted(all, "finding"));
  text += fmt::format("Of the refuted claims, {} {} of {} own", own, own == 1 ? "is a finding" : "are findings",
                      own == 1 ? "its" : "their");
  if (s.shared > 0) {
    text += fmt::format(" and {} {} again what is wrong with another claim or with a definition", s.shared,
                        s.shared == 1 ? "shows" : "show");
  }
  if (s.definitions > 0)
    text += fmt::format("; {} {} about definitions", counted(s.definitions, "finding"), is(s.definitions));
  if (s.others > 0) {
    text += fmt::format("; {} {} about claims that are not refuted, but have no value or leave something out",
                        counted(s.others, "finding"), is(s.others));
  }
  return text + ".";
}

std::string error_certainty(const Finding& finding) {
  if (!finding.disproofs.empty()) return "proved for all parameters (" + listed(finding.disproofs) + ")";
  if (finding.error == Certainty::sampled) return "sampled (" + std::to_string(finding.tried) + " samples)";
  // A counterexample, or a missing value, is exact.
  return "exact" + (finding.refutations.empty() ? "" : " (" + certificates_text(finding.refutations) + ")");
}

std::string repair_certainty(const Finding& finding) {
  std::string names = certificates_text(finding.certificates);
  if (finding.mended == Certainty::sampled) {
    names = std::to_string(finding.samples) + " samples" + (names.empty() ? "" : "; in part proved: " + names);
  }
  return std::string(name(finding.mended)) + (names.empty() ? "" : " (" + names + ")");
}

namespace {

/// The printed or the intended text. HTML typesets it and has a line for each part.
ReportLine parts_line(const FindingParts& parts) {
  if (parts.empty()) return {};
  ReportSpan whole = code(to_string(parts));
  whole.drawn = [parts](const Element& parent) {
    for (const FindingPart& part : parts) {
      const Element line = parent.add("div", "part");
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
  };
  return whole;
}

/// HTML has whole sentences.
ReportSpan explanation(const ClaimsFile& file, const std::string& text) {
  ReportSpan span = prose(file, sentence(text));
  span.text = text;
  return span;
}

}  // namespace

ReportLine finding_heading(const ClaimsFile& file, const Finding& f) {
  const std::string grade = grade_text(f);
  return {file.paper.source + ":" + std::to_string(f.line) + ": ",
          drawn(grade, [grade, css_class = "grade " + std::string(name(f.grade))](
                           const Element& parent) { parent.add("span", css_class).text(grade); }),
          " [", file.find(f.id) == nullptr ? ReportSpan(f.id) : link_to(f.id, "#claim-" + f.id),
          f.origin == Origin::ours ? "], our own" : "]"};
}

Document finding_document(const ClaimsFile& file, const Finding& f) {
  Document facts;
  facts.fact("place", file.paper.place(f.line));
  if (!f.statement.empty()) {
    const auto typeset = [text = f.statement](const Element& parent) { add_sentence(parent, text); };
    facts.fact("statement", drawn(f.statement, typeset));
  }
  facts.fact(f.origin == Origin::ours ? "stated" : "printed", parts_line(f.printed));
  facts.fact("wrong", explanation(file, f.wrong));
  facts.fact("repair", parts_line(f.repair));
  facts.fact("why", explanation(file, f.why));
  facts.fact("claims", listed(f.claims));
  facts.fact("certainty", "error " + error_certainty(f) + (f.repair.empty() ? "" : ", repair " + repair_certainty(f)));
  return facts;
}

Document errata_document(const ClaimsFile& file, const Errata& errata) {
  Document document;
  document.title(file.paper.title);
  document.line(summary_line(errata));
  document.line(standing_text(errata));
  document.line(sum_text(errata));
  for (const Finding& f : errata.findings) document.section(finding_heading(file, f)) = finding_document(file, f);
  return document;
}

std::vector<std::string> uncovered_equations(const ClaimsFile& file) {
  std::vector<std::string> missing;
  for (const auto& equation : file.paper.equations) {
    if (std::none_of(file.claims.begin(), file.claims.end(),
                     [&](const Claim& claim) { return claim.equation == equation.number; })) {
      missing.push_back(equation.number);
    }
  }
  return missing;
}

Document coverage_document(const ClaimsFile& file) {
  Document document;
  ReportTable& table = document.table({{"equation", "line", "claims"}});
  for (const auto& equation : file.paper.equations) {
    std::vector<std::string> ids;
    for (const Claim& claim : file.claims) {
      if (claim.equation == equation.number) ids.push_back(claim.id);
    }
    table.row({"(" + equation.number + ")", std::to_string(equation.line), listed(ids)});
  }
  for (const Unchecked& u : file.unchecked) table.row({u.id, std::to_string(u.line), "not judged: " + u.why});
  return document;
}

}  // namespace slipproof
