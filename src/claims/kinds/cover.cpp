// Every bicycle is in the region of one of the claims.
#include "claims/kinds/kind_base.hpp"

namespace slipproof {

namespace {

class CoverKind : public KindBase {
 public:
  CoverKind()
      : KindBase({.name = "cover",
                  .fields = {{"claims", Need::required, {"interval", "impossible"}, true}},
                  .needs_no_force = true,
                  .says_by_region = true}) {}

  Judgement judge(ClaimJudge& at) const override {
    const References& claims = at.body().claims;
    bool decided = true;
    for (const std::size_t other : claims) {
      const Truth inside = at.sample().region(at.programs(other).region);
      if (inside == Truth::yes) return ClaimJudge::holds();
      decided = decided && !ClaimJudge::no_value(inside);
    }
    if (!decided) return ClaimJudge::undecided();
    Judgement j = ClaimJudge::refuted(Reason::uncovered);
    for (const std::size_t other : claims) {  // what really happens there, in the mode that the claims are about
      const MechanismMode& mode = at.body(other).modes.front();
      const auto s = at.find(mode);
      if (!s) continue;
      j.mode = mode;
      j.real = at.forces_of(*s);
      if (!j.real->empty()) j.witnesses = j.real;
      break;
    }
    return j;
  }

  void state(ClaimWriter& writer) const override {
    const ClaimBody& claim = writer.body();
    writer.implied({"", {{"region", claim.region}}, {}, false}, writer.in_one_of(claim.claims, false));
    writer.have_values(".defined", claim.region, make_truth(true));
  }

  void refute(ClaimWriter& writer) const override {
    std::vector<Expression> truths = {writer.body().region};
    for (const std::size_t other : writer.body().claims) truths.push_back(opposite(writer.body(other).region));
    writer.somewhere(refuted_suffix, truths, {});
  }

  ClaimWords words(const ClaimBody& claim, std::string_view noun) const override {
    return {"every " + std::string(noun) + " is in the case of one of ", claim.claims};
  }
  std::string failing(const ClaimBody&, const Judgement&, std::string_view noun) const override {
    return "no case of the claim covers this " + std::string(noun);
  }
};

}  // namespace

const ClaimKind& cover_kind() {
  static const CoverKind kind;
  return kind;
}

}  // namespace slipproof
