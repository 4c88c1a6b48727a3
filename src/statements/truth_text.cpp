#include "statements/truth_text.hpp"

#include <vector>

namespace slipproof {
namespace {

Expression link(const Expression& left, Relation relation, const Expression& right) {
  return make_comparison({left, right}, {relation});
}

Relation turned(Relation relation) {
  switch (relation) {
    case Relation::less:
      return Relation::greater_equal;
    case Relation::less_equal:
      return Relation::greater;
    case Relation::greater:
      return Relation::less_equal;
    case Relation::greater_equal:
      return Relation::less;
    case Relation::equal:
      return Relation::not_equal;
    case Relation::not_equal:
      break;
  }
  return Relation::equal;
}

bool below(Relation relation) {
  return relation == Relation::less || relation == Relation::less_equal;
}

/// A comparison with `max` or `min` on one side as comparisons with what is in it.
Expression expanded(const Expression& left, Relation relation, const Expression& right) {
  const bool ordered = relation != Relation::equal && relation != Relation::not_equal;
  for (const bool on_left : {true, false}) {
    const Expression& side = on_left ? left : right;
    if (!ordered || (side->operation != Operation::maximum && side->operation != Operation::minimum)) continue;
    // Below a maximum, or above a minimum: one of them is enough.
    const bool side_is_larger = below(relation) != on_left;
    const bool both = (side->operation == Operation::maximum) != side_is_larger;
    std::vector<Expression> links;
    for (const Expression& operand : side->operands) {
      links.push_back(on_left ? expanded(operand, relation, right) : expanded(left, relation, operand));
    }
    return make(both ? Operation::logical_and : Operation::logical_or, links);
  }
  return link(left, relation, right);
}

bool has_function(const Expression& e) {
  for (const Operation function : {Operation::absolute, Operation::signum, Operation::minimum, Operation::maximum}) {
    if (e->operation == function) return true;
  }
  for (const Expression& operand : e->operands) {
    if (has_function(operand)) return true;
  }
  return false;
}

std::optional<std::string> text(const Expression& e, bool inner) {
  if (e->operation == Operation::truth) return e->truth ? "0 = 0" : "false";
  if (e->operation == Operation::logical_not) return text(opposite(e->operands[0]), inner);
  if (e->operation == Operation::compare) {
    if (!has_function(e)) return to_string(e);
    Expression links;
    for (std::size_t i = 0; i < e->relations.size(); ++i) {
      const Expression next = expanded(e->operands[i], e->relations[i], e->operands[i + 1]);
      links = links ? make(Operation::logical_and, {links, next}) : next;
    }
    if (links->operation == Operation::compare) return std::nullopt;
    return text(links, inner);
  }
  const bool both = e->operation == Operation::logical_and;
  const auto left = text(e->operands[0], e->operands[0]->operation != e->operation);
  const auto right = text(e->operands[1], true);
  if (!left || !right) return std::nullopt;
  const std::string result = *left + (both ? " and " : " or ") + *right;
  return inner ? "{" + result + "}" : result;
}

}  // namespace

std::optional<std::string> truth_text(const Expression& truth) {
  return text(truth, false);
}

Expression opposite(const Expression& e) {
  switch (e->operation) {
    case Operation::truth:
      return make_truth(!e->truth);
    case Operation::logical_not:
      return e->operands[0];
    case Operation::compare: {
      Expression result;
      for (std::size_t i = 0; i < e->relations.size(); ++i) {
        const Expression next = link(e->operands[i], turned(e->relations[i]), e->operands[i + 1]);
        result = result ? make(Operation::logical_or, {result, next}) : next;
      }
      return result;
    }
    default:
      return make(e->operation == Operation::logical_and ? Operation::logical_or : Operation::logical_and,
                  {opposite(e->operands[0]), opposite(e->operands[1])});
  }
}

}  // namespace slipproof
