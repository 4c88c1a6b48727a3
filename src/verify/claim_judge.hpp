// How each kind of claim is judged at a sample: claims about one mode, formulas and regions in judge.cpp, claims about
// all motions at a force in judge_motions.cpp.
#pragma once

#include <utility>

#include "verify/judge.hpp"
#include "verify/linear_system.hpp"

namespace slipproof {

class ClaimJudge {
 public:
  ClaimJudge(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading,
             SolvedSample& sample)
      : file_(file),
        compiled_(compiled),
        claim_(file.claims[claim]),
        body_(claim_.body(reading)),
        programs_(compiled.claims[claim].body(reading)),
        reading_(reading),
        sample_(sample) {}

  Judgement judge();

 private:
  using Known = std::vector<std::pair<ContactMode, ForceInterval>>;

  static Judgement made(Outcome outcome, Reason reason) {
    Judgement result;
    result.outcome = outcome;
    result.reason = reason;
    return result;
  }
  static Judgement refuted(Reason reason) { return made(Outcome::refuted, reason); }
  static Judgement undecided() { return made(Outcome::undecided, Reason::no_value); }
  static Judgement holds() { return made(Outcome::holds, Reason::none); }
  static bool no_value(Truth truth) { return truth == Truth::undefined || truth == Truth::undecided; }
  static ForceInterval common(ForceInterval x, const ForceInterval& y) {
    x.intersect(y);
    return x;
  }
  /// Some forces that are in one interval and not in the other; the intervals differ.
  static ForceInterval difference(const ForceInterval& x, const ForceInterval& y);

  const ForceInterval& domain() const { return *sample_.force_domain(); }
  bool strict() const { return file_.settings[claim_.setting].strict; }
  /// The forces of a mode inside the paper's domain.
  ForceInterval forces_of(const ModeSolution& s) const { return sample_.forces_of(s, strict()); }
  /// Where a claim's `forces` is true, if that is one interval.
  std::optional<ForceInterval> claimed_by(const CompiledBody& programs);
  std::optional<LinearRows> rows_of(const std::vector<std::size_t>& claims);
  std::optional<LinearRows> rows_of(const std::vector<Program>& equations);

  Judgement interval();
  Judgement impossible();
  Judgement formula();
  Judgement formula_on(std::vector<ForceInterval> where, const ModeSolution* s);
  Judgement equivalence();
  Judgement exists();
  Judgement limit();
  Judgement linear();
  Judgement cover();

  bool listed(ContactMode mode) const;
  /// Motions that count: all of an open cell that are strict (all, if the paper's conditions are not strict).
  bool counts(const FoundMotion<Affine<Rational>>& motion) const { return motion.strict || !strict(); }
  Judgement motions();
  /// The forces that another claim states in its region; nothing() outside of it.
  std::optional<ForceInterval> stated(std::size_t claim);
  /// Judged on open intervals of forces: at their ends two motions meet, and neither is strict.
  Judgement unique();
  /// Open intervals on which neither the motions nor the claims change.
  std::vector<ForceInterval> pieces(const ForceInterval& where, const std::vector<ForceInterval>& excepted,
                                    const Known& known);
  std::optional<Judgement> not_unique(const ForceInterval& piece, const Rational& force, const Known& known);

  const ClaimsFile& file_;
  const CompiledClaims& compiled_;
  const Claim& claim_;
  const ClaimBody& body_;
  const CompiledBody& programs_;
  Reading reading_;
  SolvedSample& sample_;
};

}  // namespace slipproof
