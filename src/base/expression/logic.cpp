#include "base/expression/logic.hpp"

#include <algorithm>
#include <utility>

namespace slipproof {

namespace {

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

Relation with_end(Relation relation) {
  return relation == Relation::less      ? Relation::less_equal
         : relation == Relation::greater ? Relation::greater_equal
                                         : relation;
}

}  // namespace

Expression opposite(const Expression& e) {
  switch (e->operation) {
    case Operation::truth:
      return make_truth(!e->truth);
    case Operation::logical_not:
      return e->operands[0];
    case Operation::compare: {
      Expression result;
      for (std::size_t i = 0; i < e->relations.size(); ++i) {
        const Expression next = make_comparison({e->operands[i], e->operands[i + 1]}, {turned(e->relations[i])});
        result = result ? make(Operation::logical_or, {result, next}) : next;
      }
      return result;
    }
    default:
      return make(e->operation == Operation::logical_and ? Operation::logical_or : Operation::logical_and,
                  {opposite(e->operands[0]), opposite(e->operands[1])});
  }
}

Expression closure(const Expression& e) {
  switch (e->operation) {
    case Operation::truth:
      return e;
    case Operation::logical_not:
      return closure(opposite(e->operands[0]));
    case Operation::compare: {
      if (std::find(e->relations.begin(), e->relations.end(), Relation::not_equal) == e->relations.end()) {
        std::vector<Relation> relations = e->relations;
        std::transform(relations.begin(), relations.end(), relations.begin(), with_end);
        return make_comparison(e->operands, std::move(relations));
      }
      Expression result;
      for (std::size_t i = 0; i < e->relations.size(); ++i) {
        const auto link = [&](Relation relation) {
          return make_comparison({e->operands[i], e->operands[i + 1]}, {relation});
        };
        const Expression next =
            e->relations[i] == Relation::not_equal
                ? make(Operation::logical_or, {link(Relation::less_equal), link(Relation::greater_equal)})
                : link(with_end(e->relations[i]));
        result = result ? make(Operation::logical_and, {result, next}) : next;
      }
      return result;
    }
    default:
      return make(e->operation, {closure(e->operands[0]), closure(e->operands[1])});
  }
}

bool is_true(const Expression& truth) {
  return truth->operation == Operation::truth && truth->truth;
}

Expression conjunction(const Expression& x, const Expression& y) {
  if (is_true(x)) return y;
  return is_true(y) ? x : make(Operation::logical_and, {x, y});
}

Expression all_of(const std::vector<Expression>& truths) {
  Expression result;
  for (const Expression& truth : truths) {
    result = result ? make(Operation::logical_and, {result, truth}) : truth;
  }
  return result;
}

namespace {

void collect_conjuncts(const Expression& e, std::vector<Expression>& found) {
  if (e->operation == Operation::logical_and) {
    for (const Expression& operand : e->operands) collect_conjuncts(operand, found);
  } else if (e->operation == Operation::compare) {
    for (std::size_t i = 0; i < e->relations.size(); ++i) {
      found.push_back(make_comparison({e->operands[i], e->operands[i + 1]}, {e->relations[i]}));
    }
  } else if (!is_true(e)) {
    found.push_back(e);
  }
}

}  // namespace

std::vector<Expression> conjuncts(const std::vector<Expression>& truths) {
  std::vector<Expression> found;
  for (const Expression& truth : truths) collect_conjuncts(truth, found);
  return found;
}

}  // namespace slipproof
