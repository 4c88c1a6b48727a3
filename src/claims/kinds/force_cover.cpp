// Each of the forces is covered by one of the claims: that claim's region and forces are true there.
#include "claims/kinds/kind_base.hpp"

namespace slipproof {

namespace {

class ForceCoverKind : public KindBase {
 public:
  ForceCoverKind()
      : KindBase({.name = "force-cover",
                  .fields = {{"claims", Need::required, {"interval", "motions"}, true}, {"forces", Need::optional}}}) {}

  Judgement judge(ClaimJudge& at) const override {
    const auto where = at.sample().true_at(at.programs().forces);
    // `rest`: where nothing is stated yet; `unsure`: where something may be stated.
    Intervals rest = where.parts, unsure;
    for (const std::size_t other : at.body().claims) {
      const Truth inside = at.sample().region(at.programs(other).region);
      if (inside == Truth::no) continue;
      const auto stated = at.sample().true_at(at.programs(other).forces);
      if (ClaimJudge::no_value(inside)) {
        unsure.insert(unsure.end(), stated.parts.begin(), stated.parts.end());
      } else {
        for (const ForceInterval& part : stated.parts) rest = difference(rest, part);
      }
      unsure.insert(unsure.end(), stated.unvalued.begin(), stated.unvalued.end());
    }
    Intervals bare = rest;
    for (const ForceInterval& part : unsure) bare = difference(bare, part);
    if (!bare.empty()) return ClaimJudge::refuted(Reason::uncovered, {}, std::move(bare.front()));
    if (!rest.empty() || !where.valued()) return ClaimJudge::undecided();
    return where.parts.empty() ? Judgement{} : ClaimJudge::holds();
  }

  void state(ClaimWriter& writer) const override {
    const ClaimBody& claim = writer.body();
    writer.implied_of_each({}, claim.forces, writer.in_one_of(claim.claims, true));
  }

  void refute(ClaimWriter& writer) const override {
    const ClaimBody& claim = writer.body();
    writer.somewhere(refuted_suffix, {claim.region, claim.forces, opposite(writer.in_one_of(claim.claims, true))}, {});
  }

  ClaimWords words(const ClaimBody& claim, std::string_view) const override {
    return {"each force is one of those that are stated by one of ", claim.claims};
  }
  std::string failing(const ClaimBody&, const Judgement&, std::string_view) const override {
    return "none of the claims that it names states what happens";
  }
};

}  // namespace

const ClaimKind& force_cover_kind() {
  static const ForceCoverKind kind;
  return kind;
}

}  // namespace slipproof
