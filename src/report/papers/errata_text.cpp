#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/number/format.hpp"
#include "report/papers/errata.hpp"
#include "report/papers/explain.hpp"

namespace slipproof {

namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// `certificates A, B`; empty where there are none.
std::string listed(const std::vector<std::string>& certificates) {
  if (certificates.empty()) return {};
  return (certificates.size() == 1 ? "certificate " : "certificates ") + joined(certificates);
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
  std::string text;
  for (const FindingPart& part : parts) {
    text += fmt::format("{}{}{}{}", text.empty() ? "" : "; ", part.key, part.defines ? " = " : ": ", part.text);
  }
  return text;
}

std::string grade_text(const Finding& finding) {
  return std::string(name(finding.grade)) + (finding.graded ? "" : " (no grade is given)");
}

std::string standing_text(const Errata& errata) {
  const Standing& s = errata.standing;
  if (s.judged == 0) return "No claim was judged: nothing is known of this paper.";
  std::string parts;
  const auto part = [&](std::size_t n, const char* one, const char* many, const std::string& ids = "") {
    if (n == 0) return;
    parts += fmt::format("{}{} {}{}", parts.empty() ? "" : ", ", n, n == 1 ? one : many,
                         ids.empty() ? "" : " (" + ids + ")");
  };
  part(s.proved, "is proved for all parameters", "are proved for all parameters");
  part(s.held, "holds at every bicycle that was tried", "hold at every bicycle that was tried");
  part(s.refuted, "is refuted", "are refuted");
  part(s.undecided.size(), "is undecided", "are undecided", joined(s.undecided));
  part(s.vacuous.size(), "speaks of no bicycle at all", "speak of no bicycle at all", joined(s.vacuous));
  std::string text = counted(s.judged, "claim") + (s.judged == 1 ? " was" : " were") + " judged as printed: " + parts +
                     "." + (s.missing == 0 ? "" : " " + missing_text(s.missing) + ".");
  if (!errata.findings.empty()) return text;
  if (s.undecided.size() + s.vacuous.size() > 0) return text + " No claim is refuted, yet this is no all-clear.";
  return text + (s.held == 0 ? " Nothing is wrong with what was judged."
                             : " Nothing wrong was found; what is not proved was tried at samples only.");
}

std::string sum_text(const Errata& errata) {
  const Standing& s = errata.standing;
  const std::size_t own = s.refuted - s.shared, all = errata.findings.size();
  if (s.refuted == 0 || (own == s.refuted && all == own)) return "";  // the numbers need no explanation
  std::string text = fmt::format("{} {} refuted, and there {} {}. ", counted(s.refuted, "claim"), is(s.refuted),
                                 is(all), counted(all, "finding"));
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
  if (!finding.disproofs.empty()) return "proved for all parameters (" + joined(finding.disproofs) + ")";
  if (finding.error == Certainty::sampled) return "sampled (" + std::to_string(finding.tried) + " samples)";
  // A counterexample, or a missing value, is exact.
  return "exact" + (finding.refutations.empty() ? "" : " (" + listed(finding.refutations) + ")");
}

std::string repair_certainty(const Finding& finding) {
  std::string names = listed(finding.certificates);
  if (finding.mended == Certainty::sampled) {
    names = std::to_string(finding.samples) + " samples" + (names.empty() ? "" : "; in part proved: " + names);
  }
  return std::string(name(finding.mended)) + (names.empty() ? "" : " (" + names + ")");
}

std::string errata_text(const ClaimsFile& file, const Errata& errata) {
  std::string text = file.paper.title + "\n" + summary_line(errata) + "\n" + standing_text(errata) + "\n";
  if (const std::string sum = sum_text(errata); !sum.empty()) text += sum + "\n";
  const auto line = [&](std::string_view label, const std::string& value) {
    if (!value.empty()) text += "  " + std::string(label) + ": " + value + "\n";
  };
  for (const Finding& f : errata.findings) {
    text += "\n" + file.paper.source + ":" + std::to_string(f.line) + ": " + grade_text(f) + " [" + f.id + "]\n";
    line("place", file.paper.place(f.line));
    line("statement", f.statement);
    line("printed", to_string(f.printed));
    line("wrong", f.wrong);
    line("repair", to_string(f.repair));
    line("why", f.why);
    line("claims", joined(f.claims));
    line("certainty", "error " + error_certainty(f) + (f.repair.empty() ? "" : ", repair " + repair_certainty(f)));
  }
  return text;
}

std::string errata_markdown(const ClaimsFile& file, const Errata& errata) {
  std::string text = "# Errata: " + file.paper.title + "\n\n" + summary_line(errata) + ". Lines are those of `" +
                     file.paper.source + "`.\n\n" + standing_text(errata) + "\n";
  if (const std::string sum = sum_text(errata); !sum.empty()) text += "\n" + sum + "\n";
  const auto item = [&](std::string_view label, const std::string& value, bool code) {
    if (value.empty()) return;
    text += "- **" + std::string(label) + "**: " + (code ? "`" + value + "`" : value) + "\n";
  };
  for (const Finding& f : errata.findings) {
    text += "\n## " + file.paper.where(f.line) + ", " + f.id + " (" + grade_text(f) + ")\n\n";
    item("Statement", f.statement, false);
    item("Printed", to_string(f.printed), true);
    item("What is wrong", f.wrong, false);
    item("Repair", to_string(f.repair), true);
    item("Why", f.why, false);
    item("Claims", joined(f.claims), false);
    item("How sure",
         "the error " + error_certainty(f) + (f.repair.empty() ? "" : ", the repair " + repair_certainty(f)), false);
  }
  return text;
}

}  // namespace slipproof
