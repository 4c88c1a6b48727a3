#include "report/errata.hpp"

#include <algorithm>
#include <array>

#include "claims/setting_names.hpp"
#include "number/format.hpp"
#include "report/verify_report.hpp"

namespace slipproof {

std::string_view name(Certainty certainty) {
  return certainty == Certainty::proved ? "proved for all parameters" : "sampled";
}

namespace {

/// What changes from one body to the other, as text: `region: ...; holds: ...`.
std::string changed(const ClaimBody& body, const ClaimBody& other) {
  std::string text;
  const auto add = [&](std::string_view key, const std::string& value) {
    text += (text.empty() ? "" : "; ") + std::string(key) + ": " + value;
  };
  constexpr std::array<std::string_view, 5> keys{"where", "forces", "claim", "equation", ""};
  for_each_part(body, [&](BodyPart part, std::size_t i, const Expression& expression) {
    const auto others = parts(other, part);
    const std::string_view key = keys[static_cast<std::size_t>(part)];
    const bool differs = i >= others.size() || !same(expression, *others[i]);
    if (!key.empty() && differs) add(key, to_string(expression));
  });
  if (modes(body.says) != modes(other.says)) {
    std::string names;
    for (const ContactMode mode : modes(body.says)) names += (names.empty() ? "" : ", ") + name(mode);
    add("motions", names);
  }
  return text;
}

std::string counterexample_text(const ClaimsFile& file, const ClaimResult& result) {
  std::string text = explain(file, result);
  if (!result.counterexample) return text;
  const Counterexample& e = *result.counterexample;
  const Setting& setting = file.settings[file.claims[result.claim].setting];
  text += "; for example at";
  for (std::size_t k = 0; k < e.values.size(); ++k) {
    text += (k == 0 ? " " : ", ") + setting.parameters[k].symbol + " = " + exact_text(e.values[k]);
  }
  if (e.force) text += ", " + setting.force.symbol + " = " + exact_text(*e.force);
  return text;
}

class Collection {
 public:
  Collection(const ClaimsFile& file, const VerifyResult& result) : file_(file), result_(result) {}

  std::vector<Finding> all() {
    for (std::size_t s = 0; s < file_.settings.size(); ++s) {
      for (const Definition& definition : file_.settings[s].definitions) {
        if (definition.repaired) add_definition(s, definition);
      }
    }
    for (const ClaimResult& r : result_.claims) {
      if (r.reading == Reading::printed && file_.claims[r.claim].grade && file_.claims[r.claim].part_of.empty()) {
        add_claim(r);
      }
    }
    for (const ClaimResult& r : result_.claims) {
      if (r.reading == Reading::printed) add_part(r);
    }
    std::stable_sort(found_.begin(), found_.end(), [](const auto& x, const auto& y) { return x.line < y.line; });
    return std::move(found_);
  }

 private:
  void add_definition(std::size_t setting, const Definition& definition) {
    Finding finding;
    finding.id = id(definition);
    finding.line = definition.line;
    finding.statement = definition.symbol;
    const bool undefined = definition.is_nowhere(Reading::printed);
    finding.printed = definition.symbol + (undefined ? "" : " = " + to_string(definition.printed));
    finding.repair = definition.symbol + " = " + to_string(definition.repaired);
    finding.why = definition.why;
    finding.wrong = undefined ? "the symbol is defined nowhere" : "what uses it fails";
    std::size_t failing = 0, mended = 0;
    const SettingNames names(file_.settings[setting]);
    bool proved = true;
    for (const ClaimResult& r : result_.claims) {
      const Claim& claim = file_.claims[r.claim];
      if (claim.setting != setting || !uses(names, claim, definition.symbol)) continue;
      if (r.reading == Reading::printed) {
        failing += r.verdict != Verdict::holds;
        if (r.verdict != Verdict::holds) finding.claims.push_back(claim.id);
        if (r.verdict == Verdict::refuted && !undefined && failing == 1) {
          finding.wrong = claim.id + ": " + counterexample_text(file_, r);
        }
      } else if (r.verdict == Verdict::holds) {
        ++mended;
        proved = proved && r.proved;
        add_support(finding, r);
      }
    }
    finding.wrong +=
        " (" + std::to_string(failing) + " claims fail in print, " + std::to_string(mended) + " hold with the repair)";
    finding.mended = proved && mended > 0 ? Certainty::proved : Certainty::sampled;
    found_.push_back(std::move(finding));
  }

  static bool uses(const SettingNames& names, const Claim& claim, std::string_view symbol) {
    const std::vector<Expression> all = expressions(claim.printed);
    return std::any_of(all.begin(), all.end(),
                       [&](const Expression& e) { return names.depends(e, Reading::printed, symbol); });
  }

  static void add_support(Finding& finding, const ClaimResult& holding) {
    finding.certificates.insert(finding.certificates.end(), holding.certificates.begin(), holding.certificates.end());
    if (!holding.proved) finding.samples += holding.samples();
  }

  void add_claim(const ClaimResult& printed) {
    const Claim& claim = file_.claims[printed.claim];
    const ClaimResult* repaired = result_.find(file_, claim.id, Reading::repaired);
    const std::string change = claim.repaired ? changed(*claim.repaired, claim.printed) : std::string();
    // What fails through a definition alone is the definition's finding.
    if (claim.repaired && change.empty() && *claim.grade == Grade::misprint) return;
    Finding finding;
    finding.id = claim.id;
    finding.claims = {claim.id};
    finding.line = claim.line;
    finding.grade = *claim.grade;
    finding.statement = claim.statement;
    if (claim.repaired) finding.printed = changed(claim.printed, *claim.repaired);
    if (printed.verdict == Verdict::refuted) finding.wrong = counterexample_text(file_, printed);
    if (printed.verdict == Verdict::vacuous) finding.wrong = explain(file_, printed);
    if (printed.verdict == Verdict::undecided) finding.wrong = "the claim has no value somewhere in its own region";
    if (!claim.note.empty()) finding.wrong += (finding.wrong.empty() ? "" : ". ") + claim.note;
    if (finding.wrong.empty()) finding.wrong = claim.why;
    if (repaired != nullptr && repaired->verdict == Verdict::holds) finding.repair = change;
    finding.why = claim.why;
    if (printed.verdict == Verdict::refuted) finding.refutations = printed.certificates;
    if (printed.verdict == Verdict::refuted && !printed.counterexample && finding.refutations.empty()) {
      finding.error = Certainty::sampled;
      finding.tried = result_.samples;
    }
    finding.mended = repaired != nullptr && repaired->proved ? Certainty::proved : Certainty::sampled;
    if (!finding.repair.empty()) add_support(finding, *repaired);
    found_.push_back(std::move(finding));
  }

  /// A claim that shows findings of others once more: the first of them lends it its place.
  void add_part(const ClaimResult& printed) {
    const Claim& claim = file_.claims[printed.claim];
    for (const std::string& whole : claim.part_of) {
      const auto found = std::find_if(found_.begin(), found_.end(), [&](const Finding& f) { return f.id == whole; });
      if (found == found_.end()) continue;
      if (std::find(found->claims.begin(), found->claims.end(), claim.id) == found->claims.end()) {
        found->claims.push_back(claim.id);
      }
      const Claim* own = file_.find(whole);
      if (own == nullptr) continue;
      const ClaimResult* result = result_.find(file_, whole, Reading::printed);
      const bool shown = result == nullptr || result->verdict != Verdict::holds;
      if (!shown && printed.counterexample && whole == claim.part_of.front()) {
        found->wrong += ". " + claim.id + ": " + counterexample_text(file_, printed);
      }
      if (found->error == Certainty::sampled && printed.proved) {  // what is true instead
        found->error = Certainty::proved;
        found->disproofs = printed.certificates;
      }
    }
  }

  const ClaimsFile& file_;
  const VerifyResult& result_;
  std::vector<Finding> found_;
};

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string summary_line(const std::vector<Finding>& findings) {
  std::array<int, 4> counts{};
  for (const Finding& f : findings) ++counts[static_cast<std::size_t>(f.grade)];
  std::string line = std::to_string(findings.size()) + " findings:";
  for (const Grade grade : {Grade::misprint, Grade::gap, Grade::boundary, Grade::wrong}) {
    line += (grade == Grade::misprint ? " " : ", ") + std::to_string(counts[static_cast<std::size_t>(grade)]) + " " +
            std::string(name(grade));
  }
  return line;
}

/// `certificates A, B`; empty where there are none.
std::string listed(const std::vector<std::string>& certificates) {
  if (certificates.empty()) return {};
  return (certificates.size() == 1 ? "certificate " : "certificates ") + joined(certificates);
}

}  // namespace

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

std::vector<Finding> errata(const ClaimsFile& file, const VerifyResult& result) {
  return Collection(file, result).all();
}

std::string errata_text(const ClaimsFile& file, const std::vector<Finding>& findings) {
  std::string text = file.paper.title + "\n" + summary_line(findings) + "\n";
  const auto line = [&](std::string_view label, const std::string& value) {
    if (!value.empty()) text += "  " + std::string(label) + ": " + value + "\n";
  };
  for (const Finding& f : findings) {
    text += "\n" + file.paper.source + ":" + std::to_string(f.line) + ": " + std::string(name(f.grade)) + " [" + f.id +
            "]\n";
    line("statement", f.statement);
    line("printed", f.printed);
    line("wrong", f.wrong);
    line("repair", f.repair);
    line("why", f.why);
    line("claims", joined(f.claims));
    line("certainty", "error " + error_certainty(f) + (f.repair.empty() ? "" : ", repair " + repair_certainty(f)));
  }
  return text;
}

std::string errata_markdown(const ClaimsFile& file, const std::vector<Finding>& findings) {
  std::string text = "# Errata: " + file.paper.title + "\n\n" + summary_line(findings) + ". Lines are those of `" +
                     file.paper.source + "`.\n";
  const auto item = [&](std::string_view label, const std::string& value, bool code) {
    if (value.empty()) return;
    text += "- **" + std::string(label) + "**: " + (code ? "`" + value + "`" : value) + "\n";
  };
  for (const Finding& f : findings) {
    text += "\n## Line " + std::to_string(f.line) + ", " + f.id + " (" + std::string(name(f.grade)) + ")\n\n";
    item("Statement", f.statement, false);
    item("Printed", f.printed, true);
    item("What is wrong", f.wrong, false);
    item("Repair", f.repair, true);
    item("Why", f.why, false);
    item("Claims", joined(f.claims), false);
    item("How sure",
         "the error " + error_certainty(f) + (f.repair.empty() ? "" : ", the repair " + repair_certainty(f)), false);
  }
  return text;
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

std::string coverage_markdown(const ClaimsFile& file) {
  std::string text = "| equation | line | claims |\n|---|---|---|\n";
  for (const auto& equation : file.paper.equations) {
    std::string ids;
    for (const Claim& claim : file.claims) {
      if (claim.equation == equation.number) ids += (ids.empty() ? "" : ", ") + claim.id;
    }
    text += "| (" + equation.number + ") | " + std::to_string(equation.line) + " | " + ids + " |\n";
  }
  for (const Unchecked& u : file.unchecked) {
    text += "| " + u.id + " | " + std::to_string(u.line) + " | not judged: " + u.why + " |\n";
  }
  return text;
}

}  // namespace slipproof
