#include "report/papers/errata.hpp"

#include <algorithm>
#include <array>

#include "base/number/format.hpp"
#include "base/output/listed.hpp"
#include "claims/paper/setting_names.hpp"
#include "report/papers/explain.hpp"

namespace slipproof {

std::string_view name(Certainty certainty) {
  return certainty == Certainty::proved ? "proved for all parameters" : "sampled";
}

namespace {

/// A condition as a part of a finding; `true` is put in words.
FindingPart part(std::string_view key, BodyPart what, const Expression& expression) {
  const bool always = expression->operation == Operation::truth && expression->truth;
  const char* words = what == BodyPart::region ? "everywhere" : what == BodyPart::forces ? "at every force" : "true";
  return {std::string(key), always ? nullptr : expression, always ? words : to_string(expression), false};
}

/// The parts of a body that differ from the other.
FindingParts changed(const ClaimBody& body, const ClaimBody& other) {
  FindingParts result;
  constexpr std::array<std::string_view, 5> keys{"where", "forces", "claim", "equation", ""};
  for_each_part(body, [&](BodyPart what, std::size_t i, const Expression& expression) {
    const std::string_view key = keys[static_cast<std::size_t>(what)];
    bool differs = true;
    for_each_part(other, [&](BodyPart its, std::size_t k, const Expression& others) {
      if (its == what && k == i) differs = !same(expression, others);
    });
    if (!key.empty() && differs) result.push_back(part(key, what, expression));
  });
  if (body.modes != other.modes) {
    const auto named = [](const MechanismMode& mode) { return name(mode); };
    result.push_back({"motions", nullptr, listed(body.modes, named), false});
  }
  for (const auto& [key, value] : body.own) {
    const auto found = other.own.find(key);
    if (body.kind->field(key)->only_for_proofs || (found != other.own.end() && same(value, found->second))) continue;
    result.push_back({key, value, to_string(value), false});
  }
  return result;
}

std::string counterexample_text(const ClaimsFile& file, const ClaimResult& result) {
  std::string text = explain(file, result);
  if (!result.counterexample) return text;
  text += ", for example at";
  const auto place = place_of(file, result, *result.counterexample);
  for (const auto& [symbol, value] : place) {
    text += (&symbol == &place.front().first ? " " : ", ") + symbol + " = " + exact_text(value);
  }
  const std::string built = realisability(file, result);
  return text + (built.empty() ? "" : "; " + built);
}

class Collection {
 public:
  Collection(const ClaimsFile& file, const VerifyResult& result) : file_(file), result_(result) {}

  Errata all() {
    for (std::size_t s = 0; s < file_.settings.size(); ++s) {
      for (const Definition& definition : file_.settings[s].definitions) {
        if (definition.repaired) add_definition(s, definition);
      }
    }
    for (const ClaimResult& r : result_.claims) {
      const Claim& claim = file_.claims[r.claim];
      const bool finding = claim.grade || r.verdict == Verdict::refuted;
      if (r.reading == Reading::printed && finding && claim.part_of.empty()) add_claim(r);
    }
    for (const ClaimResult& r : result_.claims) {
      if (r.reading == Reading::printed) add_part(r);
    }
    std::stable_sort(found_.begin(), found_.end(), [](const auto& x, const auto& y) { return x.line < y.line; });
    Errata errata{std::move(found_), {}};
    errata.standing = standing(errata.findings);
    return errata;
  }

 private:
  Standing standing(const std::vector<Finding>& findings) const {
    Standing s;
    const auto is_definition = [&](const Finding& f) { return file_.find(f.id) == nullptr; };
    s.definitions = static_cast<std::size_t>(std::count_if(findings.begin(), findings.end(), is_definition));
    std::size_t own = 0;  // refuted claims that have a finding of their own
    s.claims = count_claims(file_, result_);
    s.missing = result_.missing();
    for (const ClaimResult& r : result_.claims) {
      if (r.reading != Reading::printed || r.verdict != Verdict::refuted) continue;
      const std::string& id = file_.claims[r.claim].id;
      own += std::any_of(findings.begin(), findings.end(), [&](const Finding& f) { return f.id == id; });
    }
    s.shared = s.claims.all().refuted - own;
    s.others = findings.size() - s.definitions - own;
    return s;
  }

  void add_definition(std::size_t setting, const Definition& definition) {
    Finding finding;
    finding.id = id(definition);
    finding.line = definition.line;
    finding.statement = definition.symbol;
    const bool undefined = definition.is_nowhere(Reading::printed);
    if (!undefined) finding.printed = {{definition.symbol, definition.printed, to_string(definition.printed), true}};
    finding.repair = {{definition.symbol, definition.repaired, to_string(definition.repaired), true}};
    finding.why = definition.why;
    finding.wrong = "the symbol is used and defined nowhere";
    std::size_t failing = 0, mended = 0;
    const SettingNames names(file_.settings[setting]);
    if (!undefined) finding.wrong = shown_by_claim(setting, names, definition.symbol);
    bool proved = true;
    for (const ClaimResult& r : result_.claims) {
      const Claim& claim = file_.claims[r.claim];
      if (claim.setting != setting || !uses(names, claim, definition.symbol)) continue;
      if (r.reading == Reading::printed) {
        failing += r.verdict != Verdict::holds;
        if (r.verdict != Verdict::holds) finding.claims.push_back(claim.id);
      } else if (r.verdict == Verdict::holds) {
        ++mended;
        proved = proved && r.proved;
        add_support(finding, r);
      }
    }
    finding.wrong += " (" + counted(failing, "claim") + (failing == 1 ? " that uses it does" : " that use it do") +
                     " not hold as printed; " + std::to_string(mended) + (mended == 1 ? " holds" : " hold") +
                     " with the repair)";
    finding.mended = proved && mended > 0 ? Certainty::proved : Certainty::sampled;
    found_.push_back(std::move(finding));
  }

  /// Evidence that a definition is wrong: the first claim in the file that fails through the definition alone. It does
  /// not depend on which claims were judged: if that claim was not judged, it is only named.
  std::string shown_by_claim(std::size_t setting, const SettingNames& names, std::string_view symbol) const {
    for (const Claim& claim : file_.claims) {
      if (claim.setting != setting || !uses(names, claim, symbol)) continue;
      if (!claim.repaired || !changed(*claim.repaired, claim.printed).empty()) continue;
      const ClaimResult* judged = result_.find(file_, claim.id, Reading::printed);
      if (judged == nullptr && claim.printed.expect == Expectation::refuted) {
        return "claims that use it fail, as " + claim.id + " shows, which was not judged";
      }
      if (judged != nullptr && judged->verdict == Verdict::refuted) {
        return claim.id + ": " + counterexample_text(file_, *judged);
      }
    }
    return "claims that use it fail";
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
    const FindingParts change = claim.repaired ? changed(*claim.repaired, claim.printed) : FindingParts();
    // If a claim fails through a definition alone, the finding is about the definition.
    const bool mends = repaired != nullptr && repaired->verdict == Verdict::holds;
    const bool by_definition = claim.repaired && change.empty();
    if (by_definition && (claim.grade ? *claim.grade == Grade::misprint : mends)) return;
    Finding finding;
    finding.id = claim.id;
    finding.origin = claim.origin;
    finding.claims = {claim.id};
    finding.line = claim.line;
    finding.grade = claim.grade.value_or(Grade::wrong);
    finding.graded = claim.grade.has_value();
    finding.statement = claim.statement;
    if (claim.repaired) finding.printed = changed(claim.printed, *claim.repaired);
    if (printed.verdict == Verdict::refuted) finding.wrong = counterexample_text(file_, printed);
    if (printed.verdict == Verdict::vacuous || printed.verdict == Verdict::undecided) {
      finding.wrong = explain(file_, printed);
    }
    if (!claim.note.empty()) finding.wrong += (finding.wrong.empty() ? "" : ". ") + claim.note;
    if (finding.wrong.empty()) finding.wrong = claim.why;
    if (mends) finding.repair = change;
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

  /// Adds a claim that shows findings of other claims again: it is listed at the place of the first of them. If none of
  /// them is in the list, for example because those claims were not judged, a refuted claim is a finding itself.
  void add_part(const ClaimResult& printed) {
    const Claim& claim = file_.claims[printed.claim];
    const auto listed = [&](const std::string& whole) {
      return std::any_of(found_.begin(), found_.end(), [&](const Finding& f) { return f.id == whole; });
    };
    if (!claim.part_of.empty() && printed.verdict == Verdict::refuted &&
        std::none_of(claim.part_of.begin(), claim.part_of.end(), listed)) {
      return add_claim(printed);
    }
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
      if (found->error == Certainty::sampled && printed.proved) {  // the statement that is true instead
        found->error = Certainty::proved;
        found->disproofs = printed.certificates;
      }
    }
  }

  const ClaimsFile& file_;
  const VerifyResult& result_;
  std::vector<Finding> found_;
};

}  // namespace

Errata errata(const ClaimsFile& file, const VerifyResult& result) {
  return Collection(file, result).all();
}

}  // namespace slipproof
