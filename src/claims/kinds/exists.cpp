// Somewhere in the region, one of the forces gives a motion in each of the modes.
#include "claims/kinds/kind_base.hpp"

namespace slipproof {

namespace {

class ExistsKind : public KindBase {
 public:
  ExistsKind()
      : KindBase({.name = "exists",
                  .fields = {{"modes"}, {"forces", Need::optional}},
                  .seeks = true,
                  .compares_modes = Traits::Compares::always}) {}

  Judgement judge(ClaimJudge& at) const override {
    const Modes& modes = at.body().modes;
    const auto where = at.sample().true_at(at.programs().forces);
    const bool modelled =
        std::all_of(modes.begin(), modes.end(), [&](const MechanismMode& mode) { return at.find(mode).has_value(); });
    for (ForceInterval forces : where.parts) {
      if (!modelled) break;
      for (const MechanismMode& mode : modes) forces.intersect(at.forces_of(*at.find(mode)));
      if (!forces.empty()) return ClaimJudge::made(Outcome::holds, Reason::none, {}, std::move(forces));
    }
    return modelled && where.valued() ? Judgement{} : ClaimJudge::undecided();
  }
  Modes moving(const ClaimBody& claim) const override { return claim.modes; }

  void state(ClaimWriter& writer) const override {
    writer.somewhere("", {writer.body().region, writer.body().forces}, motions(writer));
  }

  /// Writes that there is no such bicycle and force anywhere.
  void refute(ClaimWriter& writer) const override {
    const ClaimBody& claim = writer.body();
    const Assumptions assumptions = {{"region", claim.region}, {"force", claim.forces}};
    writer.have_values(std::string(refuted_suffix) + ".defined", claim.region, claim.forces);
    if (claim.modes.size() == 1) {
      writer.implied({refuted_suffix, assumptions, writer.motion(claim.modes.front())}, make_truth(false));
    } else {
      writer.impossible_together(refuted_suffix, assumptions, motions(writer));
    }
  }

  bool says_nothing(const Implications&, std::size_t, const ClaimBody&) const override { return false; }

  ClaimWords words(const ClaimBody& claim, std::string_view) const override {
    return {"somewhere there is a motion in ", claim.modes};
  }

 private:
  static std::vector<StatedMotion> motions(ClaimWriter& writer) {
    std::vector<StatedMotion> all;
    for (const MechanismMode& mode : writer.body().modes) all.push_back(writer.motion(mode));
    return all;
  }
};

}  // namespace

const ClaimKind& exists_kind() {
  static const ExistsKind kind;
  return kind;
}

}  // namespace slipproof
