// None of the forces gives a motion in one of the modes.
#include "claims/kinds/kind_base.hpp"

namespace slipproof {

namespace {

class ImpossibleKind : public KindBase {
 public:
  ImpossibleKind()
      : KindBase({.name = "impossible",
                  .fields = {{"modes"}, {"forces", Need::optional}},
                  .in_planes = Traits::InPlanes::with_thresholds}) {}

  Judgement judge(ClaimJudge& at) const override {
    const auto claimed = at.sample().true_at(at.programs().forces);
    if (claimed.parts.empty()) return claimed.valued() ? Judgement{} : ClaimJudge::undecided();
    bool modelled = true;
    for (const MechanismMode& mode : at.body().modes) {
      const auto s = at.find(mode);
      modelled = modelled && s;
      if (!s) continue;
      const Intervals real = within(claimed.parts, at.forces_of(*s));
      if (real.empty()) continue;
      Judgement j = ClaimJudge::refuted(s->continuum ? Reason::continuum : Reason::exists, mode, real.front());
      j.real = real.front();
      return j;
    }
    return modelled && claimed.valued() ? ClaimJudge::holds() : ClaimJudge::undecided();
  }

  void state(ClaimWriter& writer) const override {
    writer.implied_of_each(writer.body().modes, writer.body().forces, make_truth(false));
  }

  void refute(ClaimWriter& writer) const override {
    const ClaimBody& claim = writer.body();
    writer.somewhere(refuted_suffix, {claim.region, claim.forces},
                     {writer.one_of(writer.modelled(claim.modes), writer.setting().strict)});
  }

  ClaimWords words(const ClaimBody& claim, std::string_view) const override { return {"no motion in ", claim.modes}; }

 protected:
  ClaimChange::Result settle_theorem(const ClaimChange& change) const override {
    const ClaimBody& after = change.after();
    Lemmas lemmas;
    for (const MechanismMode& mode : after.modes) {
      if (!change.in().implies({after.region, after.forces}, make_truth(false), lemmas, mode)) return std::nullopt;
    }
    return change.made(Settlement::Kind::theorem, "proved for all parameters", std::move(lemmas));
  }
};

}  // namespace

const ClaimKind& impossible_kind() {
  static const ImpossibleKind kind;
  return kind;
}

}  // namespace slipproof
