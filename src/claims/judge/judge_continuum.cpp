// Formulas about a mode with more than one solution at a force: a continuum of motions, or forces that are
// undetermined.
//
// At the forces of an interval, the solutions of a singular mode are a polytope: the force x and the free parameters
// t_1, ..., t_k under linear conditions. Every quantity is linear in them. A formula whose comparisons are linear, too,
// is false of some motion exactly if one of the conjunctions of its negation has a point in the polytope, which exact
// linear programming decides. A comparison that is not linear, or undefined, has no value here.
#include <array>

#include "base/algebra/linear_program.hpp"
#include "claims/judge/claim_judge.hpp"
#include "claims/judge/linear.hpp"

namespace slipproof {

namespace {

/// Conditions >= 0 and conditions > 0. A strict condition must be greater than the last variable, which must be
/// positive.
class Polytope {
 public:
  explicit Polytope(std::size_t variables) : variables_(variables) {}

  enum class Side : std::uint8_t { not_negative, positive };

  void require(const Linear& form, Side side) {
    AffineForm row{form.constant, std::vector<Rational>(variables_ + 1)};
    for (std::size_t i = 0; i < form.coefficients.size(); ++i) row.coefficients[i] = form.coefficients[i];
    if (side == Side::positive) row.coefficients[variables_] = -1;
    rows_.push_back(std::move(row));
  }
  void forget(std::size_t count) { rows_.resize(rows_.size() - count); }

  /// A point that satisfies all conditions; nothing if there is none.
  std::optional<std::vector<Rational>> point() const {
    std::vector<AffineForm> rows = rows_;
    AffineForm at_most_one{1, std::vector<Rational>(variables_ + 1)}, objective{0, at_most_one.coefficients};
    at_most_one.coefficients[variables_] = objective.coefficients[variables_] = -1;
    rows.push_back(at_most_one);
    LinearOptimum best = minimize(objective, rows);
    if (best.kind != LinearOptimum::Kind::attained || best.value >= 0) return std::nullopt;
    return std::move(best.x);
  }

 private:
  std::size_t variables_;
  std::vector<AffineForm> rows_;
};

/// The wanted truth of a formula at a point. The last two also accept a formula without a value.
enum class Wanted { yes, no, not_yes, not_no };

Wanted turned(Wanted wanted) {
  constexpr std::array opposites{Wanted::no, Wanted::yes, Wanted::not_no, Wanted::not_yes};
  return opposites[static_cast<std::size_t>(wanted)];
}

/// Looks for a point of the polytope at which a formula has the wanted truth, conjunction by conjunction.
class PointSearch {
 public:
  PointSearch(const Program& formula, Evaluator<Linear, LinearField>& evaluator, Polytope polytope)
      : formula_(formula), evaluator_(evaluator), polytope_(std::move(polytope)) {}

  std::optional<std::vector<Rational>> find(Wanted wanted) {
    open_ = {{formula_.root(), wanted}};
    return next();
  }

 private:
  struct Goal {
    std::uint32_t index;
    Wanted wanted;
  };
  using Point = std::optional<std::vector<Rational>>;

  Point next() {
    if (open_.empty()) return polytope_.point();
    const Goal goal = open_.back();
    open_.pop_back();
    Point found = reach(goal);
    open_.push_back(goal);
    return found;
  }

  /// The same with these goals in addition to the open ones.
  Point with(std::initializer_list<Goal> goals) {
    for (const Goal& goal : goals) open_.push_back(goal);
    Point found = next();
    open_.resize(open_.size() - goals.size());
    return found;
  }

  Point reach(Goal goal) {
    const Program::Instruction& instruction = formula_.code()[goal.index];
    const Goal first{instruction.first, goal.wanted}, second{instruction.second, goal.wanted};
    switch (instruction.operation) {
      case Operation::truth: {
        const bool wants_true = goal.wanted == Wanted::yes || goal.wanted == Wanted::not_no;
        return instruction.truth == wants_true ? next() : Point();
      }
      case Operation::logical_not:
        return with({{instruction.first, turned(goal.wanted)}});
      case Operation::logical_and:
      case Operation::logical_or: {
        const bool positive = goal.wanted == Wanted::yes || goal.wanted == Wanted::not_no;
        if ((instruction.operation == Operation::logical_and) == positive) return with({first, second});
        Point found = with({first});
        return found ? found : with({second});
      }
      default:
        return compare(instruction, goal.wanted);
    }
  }

  Point compare(const Program::Instruction& instruction, Wanted wanted) {
    const auto x = evaluator_.number(formula_, instruction.first), y = evaluator_.number(formula_, instruction.second);
    const bool valued = x.number && y.number && x.number->linear && y.number->linear;
    if (!valued) return wanted == Wanted::not_yes || wanted == Wanted::not_no ? next() : Point();
    const bool yes = wanted == Wanted::yes || wanted == Wanted::not_no;
    const Linear d = *x.number - *y.number;
    for (const int sign : {-1, 0, 1}) {
      if (holds(instruction.relation, sign) != yes) continue;
      polytope_.require(sign < 0 ? -d : d, sign == 0 ? Polytope::Side::not_negative : Polytope::Side::positive);
      if (sign == 0) polytope_.require(-d, Polytope::Side::not_negative);
      Point found = next();
      polytope_.forget(sign == 0 ? 2 : 1);
      if (found) return found;
    }
    return std::nullopt;
  }

  const Program& formula_;
  Evaluator<Linear, LinearField>& evaluator_;
  Polytope polytope_;
  std::vector<Goal> open_;
};

}  // namespace

Judgement ClaimJudge::holds_of_all(const ForceInterval& forces, const MechanismMode& mode, const ModeForms& forms) {
  const std::size_t variables = 1 + forms.free;
  const Linear x = Linear::variable(0, variables);
  const auto linear = [&](const AffineForm& form) {
    const Affine<Rational> base = sample_.in_variable(Affine<Rational>(form.constant, form.coefficients.back()));
    Linear result = x.scaled(base.beta);
    result.constant = base.alpha;
    for (std::size_t k = 0; k < forms.free; ++k) result.coefficients[k + 1] = form.coefficients[k];
    return result;
  };
  const CompiledSetting& setting = compiled();
  Evaluator<Linear, LinearField> evaluator(setting.scope());
  for (std::size_t k = 0; k < sample_.values().size(); ++k) {
    evaluator.set(CompiledSetting::parameter_slot(k), LinearField().constant(sample_.values()[k]));
  }
  evaluator.set(CompiledSetting::force_slot(), x);
  for (std::size_t q = 0; q < setting.quantities(); ++q) {
    evaluator.set(setting.quantity_slot(q), linear(quantity_form(forms, q)));
  }
  Polytope polytope(variables);
  const auto side = strict() ? Polytope::Side::positive : Polytope::Side::not_negative;
  for (const AffineForm& condition : forms.conditions) polytope.require(linear(condition), side);
  const auto end = [&](const std::optional<Rational>& value, int direction, bool closed) {
    if (!value) return;
    polytope.require((x - LinearField().constant(*value)).scaled(direction),
                     closed ? Polytope::Side::not_negative : Polytope::Side::positive);
  };
  end(forces.lower(), 1, forces.lower_closed());
  end(forces.upper(), -1, forces.upper_closed());

  PointSearch search(programs_.holds, evaluator, std::move(polytope));
  const auto point = search.find(Wanted::no);
  if (point && forms.with_cones) return undecided();  // the point may be outside of a cone
  if (point) {
    return refuted(Reason::formula, mode, ForceInterval::point(point->front()));
  }
  return search.find(Wanted::not_yes) ? undecided() : holds();
}

}  // namespace slipproof
