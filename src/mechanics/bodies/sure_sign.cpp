#include "mechanics/bodies/sure_sign.hpp"

#include <vector>

#include "base/expression/logic.hpp"

namespace slipproof::bodies_in_motion {

namespace {

Signs negated(const Signs& x) {
  return {x.positive, x.zero, x.negative};
}

Signs sum(const Signs& x, const Signs& y) {
  const bool both_ways = (x.negative && y.positive) || (x.positive && y.negative);
  return {x.negative || y.negative, (x.zero && y.zero) || both_ways, x.positive || y.positive};
}

Signs product(const Signs& x, const Signs& y) {
  return {(x.negative && y.positive) || (x.positive && y.negative), x.zero || y.zero,
          (x.positive && y.positive) || (x.negative && y.negative)};
}

/// Where there is a quotient, the divisor is not 0.
Signs quotient(const Signs& x, Signs y) {
  y.zero = false;
  return product(x, y);
}

Signs power(const Signs& x, int exponent) {
  if (exponent % 2 != 0) return x;
  return {false, x.zero && exponent > 0, exponent == 0 || x.negative || x.positive};
}

class SignReader {
 public:
  explicit SignReader(const Mechanism& mechanism) : mechanism_(mechanism) {
    for (const MechanismParameter& parameter : mechanism.parameters) {
      if (!parameter.optional) domains_.push_back(parameter.domain.expression);
    }
    for (const MechanismAngle& angle : mechanism.angles) domains_.push_back(angle.domain.expression);
    domains_ = conjuncts(domains_);
  }

  Signs of(const Expression& e) const {
    const auto operand = [&](std::size_t i) { return of(e->operands[i]); };
    switch (e->operation) {
      case Operation::number:
        return {false, e->number.is_zero(), !e->number.is_zero()};
      case Operation::symbol:
        return symbol(e->symbol);
      case Operation::negate:
        return negated(operand(0));
      case Operation::add:
        return sum(operand(0), operand(1));
      case Operation::subtract:
        return sum(operand(0), negated(operand(1)));
      case Operation::multiply:
        return product(operand(0), operand(1));
      case Operation::divide:
        return quotient(operand(0), operand(1));
      case Operation::power:
        return power(operand(0), e->exponent);
      default:
        return {};
    }
  }

 private:
  Signs symbol(const std::string& name) const {
    for (const MechanismDefinition& definition : mechanism_.definitions) {
      if (definition.symbol == name) return of(definition.expression.expression);
    }
    Signs result;
    for (const Expression& domain : domains_) {
      if (domain->operation != Operation::compare || domain->relations.size() != 1) continue;
      const Relation relation = domain->relations[0];
      if (is_symbol(domain->operands[0], name) && is_literal_zero(domain->operands[1])) {
        restrict(result, relation);
      } else if (is_literal_zero(domain->operands[0]) && is_symbol(domain->operands[1], name)) {
        restrict(result, relation == Relation::less         ? Relation::greater
                         : relation == Relation::less_equal ? Relation::greater_equal
                                                            : Relation::not_equal);
      }
    }
    return result;
  }

  /// `symbol relation 0`; other relations than these say nothing here.
  static void restrict(Signs& signs, Relation relation) {
    if (relation == Relation::greater || relation == Relation::greater_equal) signs.negative = false;
    if (relation == Relation::greater) signs.zero = false;
  }

  const Mechanism& mechanism_;
  std::vector<Expression> domains_;
};

}  // namespace

Signs sure_signs(const Mechanism& mechanism, const Expression& expression) {
  return SignReader(mechanism).of(expression);
}

}  // namespace slipproof::bodies_in_motion
