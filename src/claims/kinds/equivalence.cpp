// `forces` and `holds` are true for the same forces.
#include "claims/kinds/kind_base.hpp"

namespace slipproof {

namespace {

class EquivalenceKind : public KindBase {
 public:
  EquivalenceKind() : KindBase({.name = "equivalence", .fields = {{"forces"}, {"holds"}}, .says_by_region = true}) {}

  Judgement judge(ClaimJudge& at) const override {
    if (at.domain().empty()) return {};
    bool decided = true;
    for (const TruthCell& x : at.sample().over_forces(at.programs().forces)) {
      for (const TruthCell& y : at.sample().over_forces(at.programs().holds)) {
        ForceInterval here = ClaimJudge::common(ClaimJudge::common(x.forces, y.forces), at.domain());
        if (here.empty()) continue;
        if (ClaimJudge::no_value(x.truth) || ClaimJudge::no_value(y.truth)) {
          decided = false;
        } else if (x.truth != y.truth) {
          return ClaimJudge::refuted(Reason::formula, {}, std::move(here));
        }
      }
    }
    return decided ? ClaimJudge::holds() : ClaimJudge::undecided();
  }

  /// ID.forwards: where `forces` is true, `holds` is; ID.backwards: the converse.
  void state(ClaimWriter& writer) const override {
    const ClaimBody& claim = writer.body();
    const auto implied = [&](const char* suffix, const Expression& given, const Expression& shown) {
      writer.implied({suffix, {{"region", claim.region}, {"force", given}}, {}, true, {}, writer.always_defined(shown)},
                     shown);
    };
    implied(".forwards", claim.forces, claim.holds);
    implied(".backwards", claim.holds, claim.forces);
    writer.have_values(".defined", claim.region, claim.forces);
    writer.has_value_at_forces(".defined.holds", {{"region", claim.region}}, claim.holds);
  }

  void refute(ClaimWriter& writer) const override {
    const ClaimBody& claim = writer.body();
    const Expression differ = make(Operation::logical_or, {conjunction(claim.forces, opposite(claim.holds)),
                                                           conjunction(claim.holds, opposite(claim.forces))});
    writer.somewhere(refuted_suffix, {claim.region, differ}, {});
  }

  ClaimWords words(const ClaimBody& claim, std::string_view) const override {
    return {claim.forces, " if and only if ", claim.holds};
  }
  std::string failing(const ClaimBody&, const Judgement&, std::string_view) const override {
    return "only one of the two conditions is true";
  }

 protected:
  ClaimChange::Result settle_holds(const ClaimChange& change, const std::vector<Expression>&) const override {
    return settle_theorem(change);
  }
  ClaimChange::Result settle_theorem(const ClaimChange& change) const override {
    const ClaimBody& after = change.after();
    Lemmas lemmas;
    if (!change.in().equivalent({after.region}, after.forces, after.holds, lemmas)) return std::nullopt;
    return change.made(Settlement::Kind::theorem, "the changed inequalities are equivalent, too", std::move(lemmas));
  }
};

}  // namespace

const ClaimKind& equivalence_kind() {
  static const EquivalenceKind kind;
  return kind;
}

}  // namespace slipproof
