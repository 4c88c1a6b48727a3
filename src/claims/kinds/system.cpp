// Under `given`, the equations are equivalent to the others for their unknowns.
#include "claims/kinds/linear.hpp"

namespace slipproof {

namespace {

bool occurs(std::string_view unknown, const Equations& equations) {
  return std::any_of(equations.begin(), equations.end(), [&](const Expression& equation) {
    const std::vector<std::string> names = symbols(equation);
    return std::find(names.begin(), names.end(), unknown) != names.end();
  });
}

class SystemKind : public LinearKind {
 public:
  SystemKind() : LinearKind("system") {}

  /// ID.forwards: the equations follow. ID.backwards: every solution of the equations and those given can be completed
  /// to a solution of the equations that they follow from.
  void state(ClaimWriter& writer) const override {
    const ClaimBody& claim = writer.body();
    const Equations right = equations_of(writer, claim.given, claim.equations);
    Equations left = equations_of(writer, sources(claim), claim.assume);
    const StatedMotion motion = hypotheses(writer, left);
    std::vector<Expression> uses = left;
    uses.insert(uses.end(), right.begin(), right.end());
    const Assumptions region = {{"region", claim.region}};
    writer.implied({".forwards", region, motion, false}, writer.formula_of_all(claim.equations), uses);
    std::vector<std::string> others;
    for (const auto& unknown : writer.mechanics().unknowns()) {
      if (!occurs(unknown, right)) others.emplace_back(unknown);
    }
    if (others.empty()) {
      writer.implied({".backwards", region, StatedMotion{motion.definitions, writer.formula_of_all(right)}, false},
                     motion.formula, uses);
    } else {
      writer.exists({".backwards", {{"region", claim.region}, {"equations", all_of(right)}}, {}, false}, others, motion,
                    left);
    }
    have_values(writer, uses);
  }

  std::string failing(const ClaimBody&, const Judgement&, std::string_view) const override {
    return "the equations do not say the same as those that they are to replace";
  }

 protected:
  Judgement judge_rows(ClaimJudge& at, const Sides& rows) const override {
    if (!has_solution(rows.left) && !has_solution(rows.right)) return {};
    const bool same = equivalent(rows.left, rows.right, occurring(at));
    return same ? ClaimJudge::holds() : ClaimJudge::refuted(does_not_follow);
  }

  /// Settles a change of an assumption about unknowns that the equations do not contain: both versions may be
  /// equivalent for the unknowns that they do contain.
  ClaimChange::Result settle_assumption(const ClaimChange& change) const override {
    Lemmas lemmas;
    for (const ClaimBody* body : {&change.before(), &change.after()}) {
      if (!change.in().proves(change.claim(), *body, lemmas)) return std::nullopt;
    }
    return change.made(Settlement::Kind::equivalent, "before and after are proved to come to the same equations",
                       std::move(lemmas));
  }

  std::string relation() const override { return " say the same as "; }

 private:
  /// By unknown, whether it occurs in the text of the right side.
  static std::vector<bool> occurring(const ClaimJudge& at) {
    std::vector<bool> occurs(at.compiled().unknowns());
    const auto look = [&](const std::vector<Program>& equations) {
      for (const Program& equation : equations) {
        for (const std::size_t slot : equation.slots()) {
          for (std::size_t i = 0; i < occurs.size(); ++i)
            occurs[i] = occurs[i] || slot == at.compiled().unknown_slot(i);
        }
      }
    };
    look(at.programs().equations);
    for (const std::size_t other : at.body().given) look(at.programs(other).equations);
    return occurs;
  }
};

}  // namespace

const ClaimKind& system_kind() {
  static const SystemKind kind;
  return kind;
}

}  // namespace slipproof
