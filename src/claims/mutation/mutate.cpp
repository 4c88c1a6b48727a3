#include "claims/mutation/mutate.hpp"

#include <functional>
#include <unordered_set>
#include <utility>

namespace slipproof {

namespace {

std::string_view word(Operation operation) {
  switch (operation) {
    case Operation::add:
      return "+";
    case Operation::subtract:
      return "-";
    case Operation::multiply:
      return "*";
    case Operation::divide:
      return "/";
    case Operation::minimum:
      return "min";
    case Operation::maximum:
      return "max";
    case Operation::logical_and:
      return "and";
    default:
      return "or";
  }
}

// Walks down the tree; `around` puts a changed subtree back into the whole expression.
class FormulaEnumeration {
 public:
  explicit FormulaEnumeration(const std::vector<std::string>& symbols) : symbols_(symbols) {}
  using Around = std::function<Expression(Expression)>;

  void visit(const Expression& expression, const Around& around) {
    here_ = &expression;
    around_ = &around;
    if (sort(*expression) == Sort::number) {
      change_number();
    } else {
      change_truth();
    }
    for (std::size_t i = 0; i < expression->operands.size(); ++i) {
      visit(expression->operands[i], [&, i](Expression changed) {
        std::vector<Expression> operands = expression->operands;
        operands[i] = std::move(changed);
        return around(with_operands(*expression, std::move(operands)));
      });
    }
  }

  std::vector<Mutant> take() { return std::move(found_); }

 private:
  static Expression with_operands(const Node& node, std::vector<Expression> operands) {
    if (node.operation == Operation::power) return make_power(std::move(operands[0]), node.exponent, node.column);
    if (node.operation == Operation::compare) {
      return make_comparison(std::move(operands), node.relations, node.column);
    }
    return make(node.operation, std::move(operands), node.column);
  }

  void add(Expression changed, std::string description) {
    Expression whole = (*around_)(std::move(changed));
    if (!seen_.insert(to_string(whole)).second) return;
    found_.push_back({std::move(whole), std::move(description), (*here_)->column});
  }
  void becomes(Expression changed) {
    std::string description = to_string(*here_) + " becomes " + to_string(changed);
    add(std::move(changed), std::move(description));
  }
  void swap_operation(Operation other) {
    const Node& node = **here_;
    add(make(other, node.operands, node.column),
        std::string(word(node.operation)) + " becomes " + std::string(word(other)));
  }
  void exchange_operands() {
    const Node& node = **here_;
    add(make(node.operation, {node.operands[1], node.operands[0]}, node.column),
        "operands of " + std::string(word(node.operation)) + " exchanged");
  }

  void change_number() {
    const Expression here = *here_;
    const Node& node = *here;
    switch (node.operation) {
      case Operation::number:
        becomes(make_number(node.number + 1, node.column));
        becomes(make_number(node.number - 1, node.column));
        becomes(make_number(node.number * 2, node.column));
        becomes(make_number(-node.number, node.column));
        break;
      case Operation::symbol:
        becomes(make(Operation::multiply, {make_number(2), here}, node.column));
        becomes(make(Operation::negate, {here}, node.column));
        for (const std::string& other : symbols_) {
          if (other != node.symbol) becomes(make_symbol(other, node.column));
        }
        break;
      case Operation::negate:
        add(node.operands[0], "sign of " + to_string(node.operands[0]) + " dropped");
        break;
      case Operation::add:
        swap_operation(Operation::subtract);
        swap_operation(Operation::multiply);
        break;
      case Operation::subtract:
        swap_operation(Operation::add);
        exchange_operands();
        break;
      case Operation::multiply:
        swap_operation(Operation::divide);
        swap_operation(Operation::add);
        break;
      case Operation::divide:
        swap_operation(Operation::multiply);
        exchange_operands();
        break;
      case Operation::power:
        for (const int exponent : {node.exponent + 1, node.exponent - 1, -node.exponent}) {
          becomes(make_power(node.operands[0], exponent, node.column));
        }
        break;
      case Operation::absolute:
      case Operation::signum:
        becomes(node.operands[0]);
        break;
      case Operation::minimum:
        swap_operation(Operation::maximum);
        break;
      default:
        swap_operation(Operation::minimum);
        break;
    }
  }

  void change_truth() {
    const Expression here = *here_;
    const Node& node = *here;
    switch (node.operation) {
      case Operation::truth:
        becomes(make_truth(!node.truth, node.column));
        break;
      case Operation::compare:
        for (std::size_t i = 0; i < node.relations.size(); ++i) change_link(node, i);
        drop_links(node);
        break;
      case Operation::logical_not:
        becomes(node.operands[0]);
        break;
      case Operation::logical_and:
        swap_operation(Operation::logical_or);
        drop_operands(node);
        break;
      default:
        swap_operation(Operation::logical_and);
        drop_operands(node);
        break;
    }
  }

  static std::vector<Relation> neighbours(Relation relation) {
    switch (relation) {
      case Relation::less:
        return {Relation::less_equal, Relation::greater};
      case Relation::less_equal:
        return {Relation::less, Relation::greater_equal};
      case Relation::greater:
        return {Relation::greater_equal, Relation::less};
      case Relation::greater_equal:
        return {Relation::greater, Relation::less_equal};
      case Relation::equal:
        return {Relation::not_equal};
      case Relation::not_equal:
        return {Relation::equal};
    }
    return {};
  }

  void change_link(const Node& node, std::size_t link) {
    for (const Relation other : neighbours(node.relations[link])) {
      std::vector<Relation> relations = node.relations;
      relations[link] = other;
      becomes(make_comparison(node.operands, std::move(relations), node.column));
    }
  }

  // Drops conditions one by one: one may say nothing in addition to the others.
  void drop_operands(const Node& node) {
    for (const std::size_t kept : {1U, 0U}) {
      add(node.operands[kept], to_string(node.operands[1 - kept]) + " dropped");
    }
  }

  // Drops the lower or the upper bound of 0 < b < b1.
  void drop_links(const Node& node) {
    if (node.relations.size() < 2) return;
    becomes(make_comparison({node.operands.begin() + 1, node.operands.end()},
                            {node.relations.begin() + 1, node.relations.end()}, node.column));
    becomes(make_comparison({node.operands.begin(), node.operands.end() - 1},
                            {node.relations.begin(), node.relations.end() - 1}, node.column));
  }

  const std::vector<std::string>& symbols_;
  const Expression* here_ = nullptr;
  const Around* around_ = nullptr;
  std::vector<Mutant> found_;
  std::unordered_set<std::string> seen_;  ///< as texts, which differ for different trees
};

}  // namespace

std::vector<Mutant> mutants(const Expression& expression, const std::vector<std::string>& symbols) {
  FormulaEnumeration enumeration(symbols);
  enumeration.visit(expression, [](Expression changed) { return changed; });
  std::vector<Mutant> found = enumeration.take();
  std::erase_if(found, [&](const Mutant& mutant) { return same(mutant.expression, expression); });
  return found;
}

}  // namespace slipproof
