#include "base/expression/program.hpp"

#include <algorithm>

namespace slipproof {

Program::Program(const Expression& expression, const Resolver& resolver) {
  emit(expression, resolver);
}

Sort Program::sort() const {
  return code_.back().operation < Operation::truth ? Sort::number : Sort::truth;
}

std::vector<std::size_t> Program::slots() const {
  std::vector<std::size_t> result;
  for (const Instruction& instruction : code_) {
    if (instruction.operation == Operation::symbol) result.push_back(instruction.first);
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::uint32_t Program::push(Instruction instruction) {
  code_.push_back(instruction);
  return root();
}

std::uint32_t Program::emit(const Expression& expression, const Resolver& resolver) {
  const Node& node = *expression;
  Instruction instruction{node.operation};
  switch (node.operation) {
    case Operation::number:
      instruction.first = static_cast<std::uint32_t>(constants_.size());
      constants_.push_back(node.number);
      return push(instruction);
    case Operation::symbol:
      instruction.first = static_cast<std::uint32_t>(resolver(node.symbol).value());
      return push(instruction);
    case Operation::truth:
      instruction.truth = node.truth;
      return push(instruction);
    case Operation::compare: {
      std::vector<std::uint32_t> operands;
      for (const Expression& operand : node.operands) operands.push_back(emit(operand, resolver));
      std::optional<std::uint32_t> chain;
      for (std::size_t i = 0; i < node.relations.size(); ++i) {
        instruction.relation = node.relations[i];
        instruction.first = operands[i];
        instruction.second = operands[i + 1];
        const std::uint32_t link = push(instruction);
        chain = chain ? push({.operation = Operation::logical_and, .first = *chain, .second = link}) : link;
      }
      return *chain;
    }
    default:
      instruction.exponent = node.exponent;
      instruction.first = emit(node.operands[0], resolver);
      instruction.second = node.operands.size() > 1 ? emit(node.operands[1], resolver) : instruction.first;
      return push(instruction);
  }
}

}  // namespace slipproof
