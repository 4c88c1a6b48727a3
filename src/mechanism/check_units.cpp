#include <map>

#include "mechanism/checks.hpp"
#include "mechanism/units.hpp"

namespace slipproof {

namespace {

/// The unit of an expression: nothing where it is not known, `any` for what fits everywhere, as 0 does.
struct InferredUnit {
  std::optional<Unit> unit;
  bool any = false;
};

class UnitCheck {
 public:
  explicit UnitCheck(const Mechanism& mechanism) : mechanism_(mechanism) {}

  std::vector<MechanismFinding> check() {
    for (const MechanismParameter& p : mechanism_.parameters) declare(p.symbol, p.unit, p.place);
    if (mechanism_.load) declare(mechanism_.load->symbol, mechanism_.load->unit, mechanism_.load->place);
    for (const MechanismUnknown& u : mechanism_.unknowns) declare(u.symbol, u.unit, u.place);
    for (const MechanismAngle& angle : mechanism_.angles) {
      for (const std::string& symbol : {angle.cosine, angle.sine}) units_[symbol] = {Unit(), false};
    }
    if (units_.empty()) return {};
    for (const MechanismDefinition& definition : mechanism_.definitions) {
      units_[definition.symbol] = walk(definition.expression);
    }
    for (const MechanismParameter& p : mechanism_.parameters) walk(p.domain);
    for (const MechanismCondition& condition : mechanism_.assume) walk(condition.condition);
    for (const MechanismCondition& condition : mechanism_.realisable) walk(condition.condition);
    if (mechanism_.load) walk(mechanism_.load->domain.front());
    for (const MechanismContact& contact : mechanism_.contacts) check(contact);
    for (const MechanismFriction& friction : mechanism_.friction) {
      walk(friction.slip);
      walk(friction.static_limit);
      if (friction.kinetic_limit.expression != friction.static_limit.expression) walk(friction.kinetic_limit);
    }
    for (const MechanismLink& link : mechanism_.links) walk(link.zero);
    for (const MechanismEquation& equation : mechanism_.equations) check(equation);
    return std::move(findings_);
  }

 private:
  void declare(const std::string& symbol, const std::string& text, Place place) {
    if (text.empty()) return;
    if (auto unit = parse_unit(text)) {
      units_[symbol] = {std::move(unit), false};
    } else {
      findings_.push_back({MechanismFinding::Check::units, false, place,
                           "units: " + in_quotes(text) + " of " + symbol + " is no unit that is known"});
    }
  }

  void check(const MechanismContact& contact) {
    walk(contact.gap);
    walk(contact.slip);
    const PlacedExpression& coefficient = contact.static_friction;
    const InferredUnit unit = walk(coefficient);
    if (coefficient && unit.unit && !(*unit.unit == Unit())) {
      find(coefficient.place(), "the coefficient of friction " + in_quotes(to_string(coefficient.expression)) +
                                    " is in " + unit.unit->text() + ", expected a number");
    }
    if (contact.kinetic_friction.expression != coefficient.expression) walk(contact.kinetic_friction);
  }

  void check(const MechanismEquation& equation) {
    const InferredUnit left = walk(equation.left);
    PlacedExpression whole = equation.right;
    whole.expression = equation.whole_right();
    const InferredUnit right = walk(whole);
    agree(equation.left.place(), "the equation " + equation.name, "has", left, right);
  }

  InferredUnit walk(const PlacedExpression& placed) {
    if (!placed) return {};
    placed_ = &placed;
    return walk(placed.expression);
  }

  InferredUnit walk(const Expression& e) {
    switch (e->operation) {
      case Operation::number:
        return {Unit(), e->number.is_zero()};
      case Operation::symbol: {
        const auto found = units_.find(e->symbol);
        return found == units_.end() ? InferredUnit{} : found->second;
      }
      case Operation::power:
        return power(walk(e->operands[0]), e->exponent);
      case Operation::signum:
        walk(e->operands[0]);
        return {Unit(), false};
      case Operation::multiply:
      case Operation::divide: {
        const InferredUnit x = walk(e->operands[0]), y = walk(e->operands[1]);
        if (!x.unit || !y.unit) return {};
        Unit unit = e->operation == Operation::multiply ? *x.unit * *y.unit : *x.unit / *y.unit;
        return unit.known() ? InferredUnit{std::move(unit), x.any || y.any} : InferredUnit{};
      }
      case Operation::truth:
        return {};
      default:
        return alike(e);
    }
  }

  static InferredUnit power(const InferredUnit& base, int exponent) {
    return base.unit ? InferredUnit{base.unit->power(exponent), base.any} : InferredUnit{};
  }

  /// Sums, comparisons, min and max: the operands have one unit, which is the result's.
  InferredUnit alike(const Expression& e) {
    const bool logic = e->operation > Operation::compare;
    InferredUnit result = walk(e->operands[0]);
    for (std::size_t i = 1; i < e->operands.size(); ++i) {
      const InferredUnit next = walk(e->operands[i]);
      if (!logic) agree(placed_->place(e), in_quotes(to_string(e)), "adds or compares", result, next);
      if (!result.unit || result.any) result = next;
    }
    return result;
  }

  void agree(Place place, const std::string& what, const std::string& verb, const InferredUnit& x,
             const InferredUnit& y) {
    if (!x.unit || !y.unit || x.any || y.any || *x.unit == *y.unit) return;
    find(place, what + " " + verb + " " + x.unit->text() + " and " + y.unit->text());
  }

  void find(Place place, std::string message) {
    findings_.push_back({MechanismFinding::Check::units, true, place, std::move(message)});
  }

  const Mechanism& mechanism_;
  std::map<std::string, InferredUnit> units_;
  std::vector<MechanismFinding> findings_;
  const PlacedExpression* placed_ = nullptr;
};

}  // namespace

std::vector<MechanismFinding> check_units(const Mechanism& mechanism) {
  return UnitCheck(mechanism).check();
}

}  // namespace slipproof
