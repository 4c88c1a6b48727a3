#include "base/expression/cases.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "base/expression/logic.hpp"

namespace slipproof {

bool has_no_division(const Expression& e) {
  if (e->operation == Operation::divide || (e->operation == Operation::power && e->exponent < 0)) return false;
  return std::all_of(e->operands.begin(), e->operands.end(), has_no_division);
}

std::vector<Expression> divisors(const Expression& e) {
  std::vector<Expression> result;
  for (const Expression& operand : e->operands) {
    const std::vector<Expression> inner = divisors(operand);
    result.insert(result.end(), inner.begin(), inner.end());
  }
  if (e->operation == Operation::divide) result.push_back(e->operands[1]);
  if (e->operation == Operation::power && e->exponent < 0) result.push_back(e->operands[0]);
  return result;
}

bool is_function(const Expression& e) {
  constexpr std::array functions{Operation::absolute, Operation::signum, Operation::minimum, Operation::maximum};
  return std::find(functions.begin(), functions.end(), e->operation) != functions.end();
}

bool has_function(const Expression& e) {
  return is_function(e) || std::any_of(e->operands.begin(), e->operands.end(), has_function);
}

namespace {

Expression link(const Expression& left, Relation relation, const Expression& right) {
  return make_comparison({left, right}, {relation});
}

bool below(Relation relation) {
  return relation == Relation::less || relation == Relation::less_equal;
}

Expression replaced(const Expression& e, const Expression& function, const Expression& by) {
  if (e == function) return by;
  if (e->operands.empty()) return e;
  std::vector<Expression> operands;
  for (const Expression& operand : e->operands) operands.push_back(replaced(operand, function, by));
  if (e->operation == Operation::power) return make_power(operands[0], e->exponent);
  if (e->operation == Operation::compare) return make_comparison(std::move(operands), e->relations);
  return make(e->operation, std::move(operands));
}

class CaseWriter {
 public:
  CaseWriter(const OfExpression& wanted, const OfExpression& defined) : wanted_(wanted), defined_(defined) {}

  Expression without(const Expression& e) {
    if (e->operation == Operation::truth || !innermost(e)) return e;
    if (e->operation == Operation::logical_not) return without(opposite(e->operands[0]));
    Expression result;
    if (e->operation == Operation::compare) {
      for (std::size_t i = 0; i < e->relations.size(); ++i) {
        const Expression next = expanded(e->operands[i], e->relations[i], e->operands[i + 1]);
        if (!next) return nullptr;
        result = result ? make(Operation::logical_and, {result, next}) : next;
      }
      return result;
    }
    std::vector<Expression> operands;
    for (const Expression& operand : e->operands) {
      operands.push_back(without(operand));
      if (!operands.back()) return nullptr;
    }
    return make(e->operation, std::move(operands));
  }

 private:
  /// The first function that is wanted and has none in its operands.
  Expression innermost(const Expression& e) const {
    for (const Expression& operand : e->operands) {
      if (Expression found = innermost(operand)) return found;
    }
    return is_function(e) && wanted_(e) ? e : nullptr;
  }

  /// A comparison without functions; null if that takes too many cases.
  Expression expanded(const Expression& left, Relation relation, const Expression& right) {
    const Expression comparison = link(left, relation, right);
    const Expression function = innermost(comparison);
    if (!function) return comparison;
    if (Expression operands = by_operands(left, relation, right)) return operands;
    return by_case(comparison, function);
  }

  /// `max` or `min` on one side, of operands that have a value: below a maximum, or above a minimum, one of them is
  /// enough; otherwise it takes both.
  Expression by_operands(const Expression& left, Relation relation, const Expression& right) {
    if (relation == Relation::equal || relation == Relation::not_equal) return nullptr;
    for (const bool on_left : {true, false}) {
      const Expression& side = on_left ? left : right;
      if (side->operation != Operation::maximum && side->operation != Operation::minimum) continue;
      const bool side_is_larger = below(relation) != on_left;
      const bool both = (side->operation == Operation::maximum) != side_is_larger;
      if (!wanted_(side) || (!both && !defined_(side))) continue;
      std::vector<Expression> links;
      for (const Expression& operand : side->operands) {
        links.push_back(on_left ? expanded(operand, relation, right) : expanded(left, relation, operand));
        if (!links.back()) return nullptr;
      }
      return make(both ? Operation::logical_and : Operation::logical_or, links);
    }
    return nullptr;
  }

  Expression by_case(const Expression& comparison, const Expression& function) {
    const Expression zero = make_number(0), one = make_number(1), &x = function->operands[0];
    const auto in_case = [&](const Expression& condition, const Expression& value) -> Expression {
      if (++cases_ > 256) return nullptr;
      const Expression there = replaced(comparison, function, value);
      const Expression rest = expanded(there->operands[0], there->relations[0], there->operands[1]);
      return rest ? make(Operation::logical_and, {condition, rest}) : nullptr;
    };
    std::vector<Expression> cases;
    switch (function->operation) {
      case Operation::absolute:
        cases = {in_case(link(x, Relation::greater_equal, zero), x),
                 in_case(link(x, Relation::less, zero), make(Operation::negate, {x}))};
        break;
      case Operation::signum:
        cases = {in_case(link(x, Relation::greater, zero), one), in_case(link(x, Relation::equal, zero), zero),
                 in_case(link(x, Relation::less, zero), make(Operation::negate, {one}))};
        break;
      default: {
        const Expression& y = function->operands[1];
        const bool maximum = function->operation == Operation::maximum;
        cases = {in_case(link(x, Relation::greater_equal, y), maximum ? x : y),
                 in_case(link(x, Relation::less, y), maximum ? y : x)};
      }
    }
    Expression result;
    for (const Expression& one_case : cases) {
      if (!one_case) return nullptr;
      result = result ? make(Operation::logical_or, {result, one_case}) : one_case;
    }
    return result;
  }

  const OfExpression& wanted_;
  const OfExpression& defined_;
  int cases_ = 0;
};

}  // namespace

Expression by_cases(const Expression& truth, const OfExpression& wanted, const OfExpression& defined) {
  return CaseWriter(wanted, defined).without(truth);
}

}  // namespace slipproof
