#include <algorithm>
#include <map>
#include <utility>

#include "mechanics/checks/check_parts.hpp"
#include "mechanics/mechanism/units.hpp"

namespace slipproof::mechanism_checks {

namespace {

/// The unit of an expression: nothing if unknown, `any` if it fits everywhere, as for 0.
struct InferredUnit {
  std::optional<Unit> unit;
  bool any = false;

  bool says_something() const { return unit && !any; }
};

class UnitCheck {
 public:
  explicit UnitCheck(const Mechanism& mechanism) : mechanism_(mechanism) {
    const bool no_table = !natural();  // the library has no units: then none can show anything
    report_.scaled_well.assign(mechanism.equations.size(), no_table);
  }

  UnitReport check() {
    for (const MechanismParameter& p : mechanism_.parameters) declare(p.symbol, p.unit, p.place);
    if (mechanism_.load) declare(mechanism_.load->symbol, mechanism_.load->unit, mechanism_.load->place);
    for (const MechanismUnknown& u : mechanism_.unknowns) declare(u.symbol, u.unit, u.place);
    for (const MechanismAngle& angle : mechanism_.angles) {
      for (const std::string& symbol : {angle.cosine, angle.sine}) units_[symbol] = {Unit(), false};
    }
    if (units_.empty()) return std::move(report_);
    for (const MechanismDefinition& definition : mechanism_.definitions) {
      units_[definition.symbol] = walk(definition.expression);
    }
    for (const MechanismParameter& p : mechanism_.parameters) walk(p.domain);
    for (const MechanismCondition& condition : mechanism_.assume) walk(condition.condition);
    for (const MechanismCondition& condition : mechanism_.realisable) walk(condition.condition);
    if (mechanism_.load) walk(mechanism_.load->domain.front());
    walk(mechanism_.energy);
    if (mechanism_.by_virtual_work) check_power();
    for (const MechanismContact& contact : mechanism_.contacts) check(contact);
    for (const MechanismFriction& friction : mechanism_.friction) check(friction);
    for (const MechanismLink& link : mechanism_.links) check_force(link.force, walk(link.zero), link.name);
    for (const MechanismEquation& equation : mechanism_.equations) {
      if (!mechanism_.by_virtual_work) check(equation);
    }
    return std::move(report_);
  }

 private:
  /// What a row of [motion] times its acceleration is in, or a force times its motion.
  struct Power {
    std::string what;
    Place place;
    Unit unit;
  };

  void declare(const std::string& symbol, const std::string& text, Place place) {
    if (text.empty()) return;
    if (!has_units()) {
      if (!std::exchange(missing_table_reported_, true)) {
        report_.findings.push_back(not_checkable(
            MechanismFinding::Check::units,
            "units: udunits is not installed, which has the table of units (Debian: apt-get install libudunits2-0)",
            place));
      }
    } else if (auto unit = parse_unit(text)) {
      units_[symbol] = {std::move(unit), false};
    } else {
      report_.findings.push_back(not_checkable(MechanismFinding::Check::units,
                                               "units: " + in_quotes(text) + " of " + symbol + " is not a known unit",
                                               place));
    }
  }

  void check(const MechanismContact& contact) {
    check_force(contact.normal, walk(contact.gap), contact.gap_name);
    const InferredUnit slip = walk(contact.slip);
    if (contact.tangent) check_force(*contact.tangent, slip, contact.slip_name);
    if (contact.second) check_force(contact.second->force, walk(contact.second->slip), contact.second->name);
    const PlacedExpression& coefficient = contact.static_friction;
    const InferredUnit unit = walk(coefficient);
    if (coefficient && unit.unit && !(*unit.unit == Unit())) {
      find(coefficient.place(), "the coefficient of friction " + in_quotes(to_string(coefficient.expression)) +
                                    " is in " + unit.unit->text() + ", expected a number");
    }
    if (contact.kinetic_friction.expression != coefficient.expression) walk(contact.kinetic_friction);
  }

  /// Also that the limit of a friction element has the unit of its force.
  void check(const MechanismFriction& friction) {
    check_force(friction.force, walk(friction.slip), friction.slip_name);
    const std::string& force = mechanism_.unknowns[friction.force].symbol;
    for (const PlacedExpression* limit : {&friction.static_limit, &friction.kinetic_limit}) {
      const InferredUnit unit = walk(*limit);
      agree(limit->place(), "the limit of the force " + force, "and the force have", unit, units_[force]);
      if (friction.kinetic_limit.expression == friction.static_limit.expression) break;
    }
  }

  /// The unit of an equation whose sides agree, including the contact forces in it.
  InferredUnit check(const MechanismEquation& equation) {
    const InferredUnit left = walk(equation.left);
    PlacedExpression whole = equation.right;
    if (!mechanism_.by_virtual_work) whole.expression = equation.whole_right();
    const InferredUnit right = walk(whole);
    agree(equation.left.place(), "the equation " + equation.name, "has", left, right);
    return left.says_something() ? left : right;
  }

  /// Rows of [motion] times their accelerations are alike, and so is what forces do along their motions.
  void check_power() {
    std::vector<std::optional<Power>> rows;
    std::vector<Power> known;
    for (std::size_t i = 0; i < mechanism_.equations.size(); ++i) {
      const MechanismEquation& equation = mechanism_.equations[i];
      rows.push_back(power("row " + equation.name, check(equation), mechanism_.unknowns[i].symbol, equation.left));
      if (rows.back()) known.push_back(*rows.back());
    }
    if (known.empty()) return;
    common_ = expected_of(known);
    for (const Power& one : known) compare(one);
    const bool well = shows_scale(*common_);
    for (std::size_t i = 0; i < rows.size(); ++i) report_.scaled_well[i] = rows[i] && well;
  }

  std::optional<Power> power(const std::string& what, const InferredUnit& unit, const std::string& acceleration,
                             const PlacedExpression& placed) {
    const InferredUnit& along = units_[acceleration];
    if (!unit.says_something() || !along.unit) return std::nullopt;
    Unit product = *unit.unit * *along.unit;
    if (!product.known()) return std::nullopt;
    return Power{what + " times " + acceleration, placed.place(), std::move(product)};
  }

  /// Of a force times an acceleration.
  static const std::optional<Unit>& natural() {
    static const std::optional<Unit> unit = parse_unit("kg m^2/s^4");
    return unit;
  }

  /// The natural one if any row has it, or the most common.
  static Unit expected_of(const std::vector<Power>& all) {
    const auto is_natural = [](const Power& one) { return natural() && one.unit.same_dimension(*natural()); };
    const auto found = std::ranges::find_if(all, is_natural);
    if (found != all.end()) return found->unit;
    const auto votes = [&](const Power& one) {
      return std::ranges::count_if(all, [&](const Power& other) { return other.unit == one.unit; });
    };
    return std::ranges::max_element(all, {}, votes)->unit;
  }

  void compare(const Power& one) {
    if (!one.unit.known() || one.unit == *common_) return;
    find(one.place, one.what + " is in " + one.unit.text() + ", others in " + common_->text() +
                        ", expected the same: virtual work adds contact forces to rows, which must not be divided");
  }

  /// A force whose unit is not given has the one that virtual work asks for.
  void check_force(std::size_t force, const InferredUnit& along, const std::string& motion) {
    if (!common_ || !along.says_something()) return;
    const MechanismUnknown& unknown = mechanism_.unknowns[force];
    InferredUnit& own = units_[unknown.symbol];
    if (own.unit) {
      compare({"the force " + unknown.symbol + " times " + motion, unknown.place, *own.unit * *along.unit});
    } else if (Unit unit = *common_ / *along.unit; unit.known()) {
      own = {std::move(unit), false};
    }
  }

  /// Whether the unit of rows times accelerations shows that no row is divided by a mass of its own: it is that of a
  /// force times an acceleration, or only one symbol has the missing unit.
  bool shows_scale(const Unit& common) {
    if (!natural() || common.same_dimension(*natural())) return natural().has_value();
    const Unit divisor = *natural() / common;
    std::vector<Unit> units;
    for (const MechanismParameter& p : mechanism_.parameters) {
      if (const auto& unit = units_[p.symbol].unit) units.push_back(*unit);
    }
    for (const MechanismDefinition& d : mechanism_.definitions) {
      if (const auto& unit = units_[d.symbol].unit) units.push_back(*unit);
    }
    std::size_t divisors = 0;
    for (std::size_t i = 0; i < units.size(); ++i) {
      divisors += units[i].same_dimension(divisor) ? 1 : 0;
      for (std::size_t k = 0; k < i; ++k) {
        const bool numbers = units[i].same_dimension(Unit()) || units[k].same_dimension(Unit());
        divisors += !numbers && (units[i] * units[k]).same_dimension(divisor) ? 1 : 0;
      }
    }
    return divisors < 2;
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
    report_.findings.push_back(warning(MechanismFinding::Check::units, place, std::move(message)));
  }

  const Mechanism& mechanism_;
  std::map<std::string, InferredUnit> units_;
  UnitReport report_;
  bool missing_table_reported_ = false;  ///< whether the missing table of units was reported
  std::optional<Unit> common_;           ///< of rows of [motion] times their accelerations
  const PlacedExpression* placed_ = nullptr;
};

}  // namespace

UnitReport check_units(const Mechanism& mechanism) {
  return UnitCheck(mechanism).check();
}

}  // namespace slipproof::mechanism_checks
