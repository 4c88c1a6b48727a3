// What a kind uses to judge a claim at a sample, and the forms of its results.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "claims/judge/judge.hpp"

namespace slipproof {

class ClaimJudge {
 public:
  using Intervals = std::vector<ForceInterval>;

  ClaimJudge(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading,
             SolvedSample& sample)
      : file_(file),
        compiled_(compiled),
        claim_(file.claims[claim]),
        programs_(compiled.claims[claim].body(reading)),
        reading_(reading),
        sample_(sample) {}

  Judgement judge();

  const ClaimBody& body() const { return claim_.body(reading_); }
  const CompiledBody& programs() const { return programs_; }
  /// The body of another claim.
  const ClaimBody& body(std::size_t claim) const { return file_.claims[claim].body(reading_); }
  const CompiledBody& programs(std::size_t claim) const { return compiled_.claims[claim].body(reading_); }
  const Setting& setting() const { return file_.settings[claim_.setting]; }
  const CompiledSetting& compiled() const { return compiled_.settings[claim_.setting]; }
  SolvedSample& sample() { return sample_; }

  const ForceInterval& domain() const { return *sample_.force_domain(); }
  bool strict() const { return setting().strict; }
  /// The forces of a mode in the paper's domain.
  ForceInterval forces_of(const ModeOverLoads& mode) const { return sample_.forces_of(mode, strict()); }
  /// Nothing if the mode is not modelled.
  std::optional<ModeOverLoads> find(const MechanismMode& mode) { return sample_.motions().find(mode); }
  /// Whether all states of all elements are modelled.
  bool complete() const { return compiled().complete(); }

  /// Judges `holds` for all solutions of a mode that has more than one solution at a force, over the forces that
  /// `forces` and the mode have in common.
  Judgement holds_of_all(const ForceInterval& forces, const MechanismMode& mode, const ModeForms& forms);

  static Judgement made(Outcome outcome, Reason reason, std::optional<MechanismMode> mode = {},
                        std::optional<ForceInterval> witnesses = {}) {
    Judgement result;
    result.outcome = outcome;
    result.reason = reason;
    result.mode = std::move(mode);
    result.witnesses = std::move(witnesses);
    return result;
  }
  static Judgement refuted(Reason reason, std::optional<MechanismMode> mode = {},
                           std::optional<ForceInterval> witnesses = {}) {
    return made(Outcome::refuted, reason, std::move(mode), std::move(witnesses));
  }
  static Judgement undecided() { return made(Outcome::undecided, Reason::no_value); }
  static Judgement holds() { return made(Outcome::holds, Reason::none); }
  /// Combines the judgements of several forces, modes or bicycles: returns the first of wrong, no value, right, nothing
  /// that occurs.
  template <class Items, class Judge>
  static Judgement first_of(const Items& items, const Judge& judge) {
    Judgement result;
    for (const auto& item : items) {
      Judgement j = judge(item);
      if (j.outcome == Outcome::refuted) return j;
      if (j.outcome == Outcome::undecided || result.outcome == Outcome::outside) result = std::move(j);
    }
    return result;
  }
  static bool no_value(Truth truth) { return truth == Truth::undefined || truth == Truth::undecided; }
  static ForceInterval common(ForceInterval x, const ForceInterval& y) {
    x.intersect(y);
    return x;
  }

 private:
  Judgement judged();
  /// Whether the compared values exist at all forces but the comparison was not decided.
  bool is_unsure();

  const ClaimsFile& file_;
  const CompiledClaims& compiled_;
  const Claim& claim_;
  const CompiledBody& programs_;
  Reading reading_;
  SolvedSample& sample_;
};

}  // namespace slipproof
