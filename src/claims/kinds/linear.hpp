// The common part of claims about equations that are linear in the unknowns. They are judged and displayed as
// equations, not by motions.
#pragma once

#include "claims/judge/linear_system.hpp"
#include "claims/kinds/kind_base.hpp"

namespace slipproof {

class LinearKind : public KindBase {
 public:
  explicit LinearKind(std::string_view name);

  Judgement judge(ClaimJudge& at) const override;
  /// Also for a system: writes that one direction fails.
  void refute(ClaimWriter& writer) const override;
  ClaimChange::Result settle(const ClaimChange& change) const override;
  ClaimWords words(const ClaimBody& claim, std::string_view noun) const override;

 protected:
  static constexpr Reason does_not_follow{"equation"};
  /// The rows of a claim: its hypotheses, its equations, and the complete right side of a system.
  struct Sides {
    LinearRows left, equations, right;
  };
  virtual Judgement judge_rows(ClaimJudge& at, const Sides& rows) const = 0;
  /// Settle a change of an assumption and of an equation, if the other equations do not make both versions the same.
  virtual ClaimChange::Result settle_assumption(const ClaimChange& change) const;
  virtual ClaimChange::Result settle_equation(const ClaimChange& change, const Expression& changed) const;
  /// The words between hypotheses and equations.
  virtual std::string relation() const = 0;

  /// The equations of claims, followed by others.
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
  /// The claims in `given`, then those in `claims`.
  static References sources(const ClaimBody& claim);
  /// The hypotheses: `others` and the equations of the claims and of `assume`.
  static StatedMotion hypotheses(ClaimWriter& writer, const Equations& others);
  /// States that no equation divides by 0, for any numbers in place of the unknowns, and that the region has a value.
  /// Gives up if an equation is not linear.
  static void have_values(ClaimWriter& writer, const Equations& equations);
  /// A claim has no value if an equation is not linear.
  static void give_up_unless_linear(ClaimWriter& writer, const Equations& equations);
};

}  // namespace slipproof
