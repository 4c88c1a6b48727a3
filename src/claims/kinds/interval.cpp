// In the region, the forces with a motion in the mode are exactly those of `forces`.
#include "claims/kinds/kind_base.hpp"

namespace slipproof {

namespace {

class IntervalKind : public KindBase {
 public:
  IntervalKind()
      : KindBase({.name = "interval",
                  .fields = {{"mode"}, {"forces"}},
                  .needs_no_force = true,
                  .says_by_region = true,
                  .in_planes = Traits::InPlanes::with_thresholds}) {}

  Judgement judge(ClaimJudge& at) const override {
    const MechanismMode& mode = at.body().modes.front();
    const auto s = at.find(mode);
    const auto claimed = at.sample().true_at(at.programs().forces);
    if (!s) return ClaimJudge::undecided();
    ForceInterval real = at.forces_of(*s);
    Intervals differ = difference(claimed.parts, real);
    if (differ.empty()) {
      differ = {real};
      for (const Intervals* parts : {&claimed.parts, &claimed.unvalued}) {
        for (const ForceInterval& part : *parts) differ = difference(differ, part);
      }
      std::erase_if(differ, [](const ForceInterval& forces) { return forces.empty(); });
    }
    if (differ.empty()) return claimed.valued() ? ClaimJudge::holds() : ClaimJudge::undecided();
    std::optional<ForceInterval> one;
    if (claimed.parts.size() < 2) one = claimed.parts.empty() ? ForceInterval::nothing() : claimed.parts.front();
    const bool ends =
        one && !one->empty() && !real.empty() && one->interior() == real.interior() && !one->interior().empty();
    // Whether there is a continuum where the two differ.
    const bool continuum = s->continuum && !ClaimJudge::common(real, differ.front()).empty();
    Judgement j = ClaimJudge::refuted(ends        ? Reason::ends
                                      : continuum ? Reason::continuum
                                                  : Reason::forces,
                                      mode, std::move(differ.front()));
    j.claimed = std::move(one);
    j.real = std::move(real);
    return j;
  }

  /// ID.only-then: a motion in the mode needs a force of `forces`; ID.always: each such force has a motion.
  void state(ClaimWriter& writer) const override {
    const ClaimBody& claim = writer.body();
    const StatedMotion motion = writer.motion(claim.modes.front());
    writer.implied({".only-then", {{"region", claim.region}}, motion, true, {}, writer.always_defined(claim.forces)},
                   claim.forces);
    writer.exists({".always", {{"region", claim.region}, {"force", claim.forces}}, {}, true, {}, true}, motion);
    writer.have_values(".defined", claim.region, claim.forces);
  }

  void refute(ClaimWriter& writer) const override {
    const ClaimBody& claim = writer.body();
    writer.somewhere(refuted_suffix, {claim.region, opposite(claim.forces)}, {writer.motion(claim.modes.front())});
  }

  ClaimWords words(const ClaimBody& claim, std::string_view) const override {
    return {claim.modes, " is a motion exactly for ", claim.forces};
  }
};

}  // namespace

const ClaimKind& interval_kind() {
  static const IntervalKind kind;
  return kind;
}

}  // namespace slipproof
