// How each kind of claim is judged at a sample, a function for each row of the table in proofs/MEANING.md: claims about
// single modes, formulas and regions in judge.cpp, about all motions at a force in judge_motions.cpp, about a continuum
// in judge_continuum.cpp.
#pragma once

#include <utility>

#include "claims/judge/judge.hpp"
#include "claims/judge/linear_system.hpp"

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
  Judgement judged();
  /// Whether what it compares over the forces has a value everywhere, but was not decided.
  bool is_unsure();
  using Intervals = std::vector<ForceInterval>;
  /// Where a claim that uniqueness refers to states forces, and where it is near them: their ends included.
  struct Stated {
    MechanismMode mode;
    Intervals forces, near;
  };

  static Judgement made(Outcome outcome, Reason reason) {
    Judgement result;
    result.outcome = outcome;
    result.reason = reason;
    return result;
  }
  static Judgement refuted(Reason reason) { return made(Outcome::refuted, reason); }
  static Judgement undecided() { return made(Outcome::undecided, Reason::no_value); }
  static Judgement holds() { return made(Outcome::holds, Reason::none); }
  /// Judgements of several forces, modes or bicycles as one: the first of wrong, no value, right, nothing that occurs.
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
  static bool contains(const Intervals& parts, const Rational& force);

  const ForceInterval& domain() const { return *sample_.force_domain(); }
  bool strict() const { return file_.settings[claim_.setting].strict; }
  /// The forces of a mode inside the paper's domain.
  ForceInterval forces_of(const ModeOverLoads& mode) const { return sample_.forces_of(mode, strict()); }
  /// Nothing for a mode that is not modelled.
  std::optional<ModeOverLoads> find(const MechanismMode& mode) { return sample_.motions().find(mode); }
  bool complete() const { return compiled_.settings[claim_.setting].complete(); }

  Judgement of(const Interval& claim);
  Judgement of(const Impossible& claim);
  Judgement of(const Formula& claim);
  Judgement of(const Motions& claim);
  Judgement of(const Unique& claim);
  Judgement of(const Cover& claim);
  Judgement of(const ForceCover& claim);
  Judgement of(const Equivalence& claim);
  Judgement of(const Limit& claim);
  Judgement of(const Exists& claim);
  Judgement of(const Consequence& claim);
  Judgement of(const System& claim);

  Judgement formula_in_modes(const Modes& modes, const Intervals& where);
  Judgement formula_in(const MechanismMode& mode, const ModeOverLoads& s, Intervals here);
  /// Of functions of the force; of a mode, of those that its motion is.
  Judgement formula_on(const Intervals& here, const MechanismMode* mode);
  /// Of all solutions of a mode at the forces.
  Judgement formula_about_all(const ForceInterval& forces, const MechanismMode& mode, const ModeForms& forms);

  /// The rows of a claim of equations: its hypotheses, what it says, and the whole right side of a system.
  struct Sides {
    LinearRows left, equations, right;
  };
  std::optional<Sides> sides(const LinearEquations& claim);
  std::optional<LinearRows> rows_of(const References& claims);
  std::optional<LinearRows> rows_of(const std::vector<Program>& equations);
  /// The unknowns that the text of a system's right side has.
  std::vector<bool> occurring(const LinearEquations& claim) const;

  /// The motions of a cell that count: in a strict setting those that are strict.
  std::vector<const MotionOverLoads*> counted(const LoadCell& cell) const;
  /// The modes of a motion that count.
  Modes modes_of(const MotionOverLoads& motion) const;
  /// A mode with a continuum of motions that count at the forces of a cell.
  std::optional<MechanismMode> continuum_at(const LoadCell& cell);
  std::optional<Judgement> other_motions(const Motions& claim, const LoadCell& cell);
  /// Nothing where a condition of it has no value.
  std::optional<Stated> stated(std::size_t claim);
  /// Points and open intervals of forces on which neither the motions nor the claims change.
  Intervals pieces(const std::vector<Intervals>& changes);
  std::optional<Judgement> not_one_motion(const ForceInterval& piece, const Modes& expected);

  const ClaimsFile& file_;
  const CompiledClaims& compiled_;
  const Claim& claim_;
  const ClaimBody& body_;
  const CompiledBody& programs_;
  Reading reading_;
  SolvedSample& sample_;
};

}  // namespace slipproof
