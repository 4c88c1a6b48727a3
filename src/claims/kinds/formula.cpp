// `holds` at all of the forces; if there are modes, for the quantities of every motion in them.
#include "claims/kinds/kind_base.hpp"

namespace slipproof {

namespace {

/// Judges over functions of the force; for a mode, over the functions that describe its motion.
Judgement holds_on(ClaimJudge& at, const ClaimJudge::Intervals& here, const std::optional<MechanismMode>& mode) {
  bool decided = true;
  for (const TruthCell& cell : at.sample().over_forces(at.programs().holds)) {
    for (const ForceInterval& forces : here) {
      ForceInterval both = ClaimJudge::common(cell.forces, forces);
      if (both.empty() || cell.truth == Truth::yes) continue;
      decided = decided && !ClaimJudge::no_value(cell.truth);
      if (!ClaimJudge::no_value(cell.truth)) return ClaimJudge::refuted(Reason::formula, mode, std::move(both));
    }
  }
  return decided ? ClaimJudge::holds() : ClaimJudge::undecided();
}

Judgement holds_in(ClaimJudge& at, const ClaimJudge::Intervals& where, const MechanismMode& mode) {
  const auto s = at.find(mode);
  if (!s) return ClaimJudge::undecided();
  const ClaimJudge::Intervals here = within(where, at.forces_of(*s));
  if (here.empty()) return {};
  const ModeForms& forms = *at.sample().motions().forms(mode);
  if (at.sample().set_motion(forms, at.programs().holds.slots())) return holds_on(at, here, mode);
  return ClaimJudge::first_of(here, [&](const ForceInterval& forces) { return at.holds_of_all(forces, mode, forms); });
}

class FormulaKind : public KindBase {
 public:
  FormulaKind()
      : KindBase(
            {.name = "formula",
             .fields = {{"mode", Need::optional}, {"modes", Need::optional}, {"forces", Need::optional}, {"holds"}}}) {}

  Judgement judge(ClaimJudge& at) const override {
    const Modes& modes = at.body().modes;
    const auto where = at.sample().true_at(at.programs().forces);
    Judgement j;
    if (!where.parts.empty()) {
      j = modes.empty()
              ? holds_on(at, where.parts, {})
              : ClaimJudge::first_of(modes, [&](const MechanismMode& mode) { return holds_in(at, where.parts, mode); });
    }
    return where.valued() || j.outcome == Outcome::refuted ? j : ClaimJudge::undecided();
  }
  Modes moving(const ClaimBody& claim) const override { return claim.modes.size() == 1 ? claim.modes : Modes{}; }

  void state(ClaimWriter& writer) const override {
    writer.implied_of_each(writer.body().modes, writer.body().forces, writer.body().holds);
  }

  void refute(ClaimWriter& writer) const override {
    const ClaimBody& claim = writer.body();
    std::vector<StatedMotion> motions;
    if (claim.modes.size() == 1) motions = {writer.motion(claim.modes.front())};
    if (claim.modes.size() > 1) {
      motions = {writer.one_of(writer.modelled(claim.modes), writer.setting().strict)};
    }
    writer.somewhere(refuted_suffix, {claim.region, claim.forces, opposite(claim.holds)}, motions);
  }

  bool may_be_identity(const ClaimBody&) const override { return true; }

  bool says_nothing(const Implications& logic, std::size_t claim, const ClaimBody& body) const override {
    if (body.modes.empty()) return KindBase::says_nothing(logic, claim, body);
    Lemmas lemmas;
    if (!logic.has_value({body.region}, body.forces, lemmas)) return false;
    return std::all_of(body.modes.begin(), body.modes.end(), [&](const MechanismMode& mode) {
      return logic.implies({body.region, body.forces}, make_truth(false), lemmas, mode);
    });
  }

  ClaimWords words(const ClaimBody& claim, std::string_view) const override {
    if (claim.modes.empty()) return {claim.holds};
    return {"in ", claim.modes, ", ", claim.holds};
  }
  std::string failing(const ClaimBody&, const Judgement&, std::string_view) const override {
    return "what the claim says is false";
  }

 protected:
  ClaimChange::Result settle_holds(const ClaimChange& change, const std::vector<Expression>& given) const override {
    std::vector<Expression> weaker = given;
    weaker.push_back(change.before().holds);
    Lemmas lemmas;
    if (change.in().implies(weaker, change.after().holds, lemmas) &&
        (change.was_identity() || follows(change, change.before(), lemmas))) {
      return change.made(Settlement::Kind::theorem, "it follows from the claim, which is proved", std::move(lemmas));
    }
    return settle_theorem(change);
  }

  ClaimChange::Result settle_theorem(const ClaimChange& change) const override {
    if (change.is_identity()) return change.made(Settlement::Kind::theorem, "an identity of rational functions");
    Lemmas lemmas;
    if (!follows(change, change.after(), lemmas)) return std::nullopt;
    return change.made(Settlement::Kind::theorem, "proved for all parameters", std::move(lemmas));
  }

 private:
  /// Whether the changed formula follows for all parameters; about one mode, or none.
  static bool follows(const ClaimChange& change, const ClaimBody& body, Lemmas& lemmas) {
    return body.modes.size() < 2 && change.in().implies({body.region, body.forces}, body.holds, lemmas, body.mode());
  }
};

}  // namespace

const ClaimKind& formula_kind() {
  static const FormulaKind kind;
  return kind;
}

}  // namespace slipproof
