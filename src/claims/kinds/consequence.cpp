// Every equation follows from those of `given`, `assume` and `claims`, or from the model's.
#include "claims/kinds/linear.hpp"

namespace slipproof {

namespace {

class ConsequenceKind : public LinearKind {
 public:
  ConsequenceKind() : LinearKind("consequence") {}

  /// Writes the statement as linear equations, in the force too, so that it is about any force.
  void state(ClaimWriter& writer) const override {
    const ClaimBody& claim = writer.body();
    const Equations others = equations_of(writer, sources(claim), claim.assume);
    Equations all = others;
    all.insert(all.end(), claim.equations.begin(), claim.equations.end());
    std::vector<Expression> uses = others;
    uses.push_back(all_of(claim.equations));
    writer.implied({"", {{"region", claim.region}}, hypotheses(writer, others), false},
                   writer.formula_of_all(claim.equations), uses);
    have_values(writer, all);
  }

  bool may_be_identity(const ClaimBody& claim) const override {
    return claim.from_model() && claim.assume.empty() && !claim.modes.empty();
  }

  /// True if its hypotheses contradict each other, and its equations have values; or if its region is empty.
  bool says_nothing(const Implications& logic, std::size_t claim, const ClaimBody& body) const override {
    ClaimBody absurd = body;
    absurd.equations = {make_comparison({make_number(0), make_number(1)}, {Relation::equal})};
    Lemmas lemmas;
    const auto has_value = [&](const Expression& equation) {
      return logic.is_linear(equation) && logic.of_any_force().has_value({body.region}, equation, lemmas);
    };
    return (std::all_of(body.equations.begin(), body.equations.end(), has_value) &&
            logic.proves(claim, absurd, lemmas)) ||
           KindBase::says_nothing(logic, claim, body);
  }

  std::string failing(const ClaimBody& claim, const Judgement& judgement, std::string_view) const override {
    const std::string from = claim.from_model() ? "the equations of motion" : "what is given";
    if (!judgement.number) return "an equation does not follow from " + from;
    return to_string(claim.equations[*judgement.number]) + " does not follow from " + from;
  }

 protected:
  Judgement judge_rows(ClaimJudge&, const Sides& rows) const override {
    if (!has_solution(rows.left)) return {};
    if (follows(rows.equations, rows.left)) return ClaimJudge::holds();
    Judgement j = ClaimJudge::refuted(does_not_follow);
    for (std::size_t i = 0; i < rows.equations.size() && !j.number; ++i) {
      if (!follows({rows.equations[i]}, rows.left)) j.number = i;
    }
    return j;
  }

  ClaimChange::Result settle_equation(const ClaimChange& change, const Expression& changed) const override {
    if (change.is_identity()) return change.made(Settlement::Kind::theorem, "an identity of rational functions");
    const ClaimBody& before = change.before();
    std::vector<Expression> given{before.region};
    const auto claims_in = [&](std::size_t claim) -> const ClaimBody& { return change.other(claim); };
    const Equations others = equations_of(claims_in, sources(before), before.assume);
    given.insert(given.end(), others.begin(), others.end());
    const Obeying obeying = before.from_model() ? Obeying::equations_on_road : Obeying::nothing;
    Lemmas lemmas;
    const Implications in = change.in().of_any_force();
    if (!in.implies(given, changed, lemmas, std::nullopt, obeying)) return std::nullopt;
    return change.made(Settlement::Kind::theorem, "it follows for all parameters", std::move(lemmas));
  }

  std::string relation() const override { return " imply "; }
};

}  // namespace

const ClaimKind& consequence_kind() {
  static const ConsequenceKind kind;
  return kind;
}

}  // namespace slipproof
