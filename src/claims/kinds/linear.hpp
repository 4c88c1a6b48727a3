// What claims of equations that are linear in the unknowns have in common: they are judged and shown as equations, not
// by motions.
#pragma once

#include "claims/judge/linear_system.hpp"
#include "claims/kinds/kind_base.hpp"

namespace slipproof {

class LinearKind : public KindBase {
 public:
  explicit LinearKind(std::string_view name);

  Judgement judge(ClaimJudge& at) const override;
  /// Also of a system: that one direction fails.
  void refute(ClaimWriter& writer) const override;
  ClaimChange::Result settle(const ClaimChange& change) const override;
  ClaimWords words(const ClaimBody& claim, std::string_view noun) const override;

 protected:
  /// The rows of a claim: its hypotheses, what it says, and the whole right side of a system.
  struct Sides {
    LinearRows left, equations, right;
  };
  virtual Judgement judge_rows(ClaimJudge& at, const Sides& rows) const = 0;
  /// Of another assumption, and of another equation, where the equations beside it do not make them the same.
  virtual ClaimChange::Result settle_assumption(const ClaimChange& change) const;
  virtual ClaimChange::Result settle_equation(const ClaimChange& change, const Expression& changed) const;
  /// Between hypotheses and equations, in words.
  virtual std::string relation() const = 0;

  /// The equations of claims, and others.
  template <class Claims>
  static Equations equations_of(const Claims& claims_in, const References& claims, const Equations& others = {}) {
    Equations all;
    for (const std::size_t claim : claims) {
      const Equations& more = claims_in(claim).equations;
      all.insert(all.end(), more.begin(), more.end());
    }
    all.insert(all.end(), others.begin(), others.end());
    return all;
  }
  static Equations equations_of(const ClaimWriter& writer, const References& claims, const Equations& others = {}) {
    return equations_of([&](std::size_t claim) -> const ClaimBody& { return writer.body(claim); }, claims, others);
  }
  /// `given` before `claims`.
  static References sources(const ClaimBody& claim);
  static std::string conjunction(ClaimWriter& writer, const Equations& equations);
  /// The hypotheses, with the equations of claims and of `assume` among them as `others`.
  static MotionText hypotheses(ClaimWriter& writer, const Equations& others);
  /// That equations divide by nothing that vanishes, for any numbers in place of the unknowns; and the region.
  static void have_values(ClaimWriter& writer, const Equations& equations);
};

}  // namespace slipproof
