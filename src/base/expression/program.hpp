// Expressions made ready for evaluation: names resolved to slots once, so that the hot loops look nothing up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "base/expression/expression.hpp"

namespace slipproof {

/// A resolved expression: a tree in an array, children before parents.
class Program {
 public:
  struct Instruction {
    Operation operation;
    Relation relation = Relation::equal;  ///< of a comparison, which has two operands here; chains become conjunctions
    bool truth = false;
    int exponent = 0;
    std::uint32_t first = 0;   ///< operand, or the slot of a symbol, or the constant of a number
    std::uint32_t second = 0;  ///< second operand; the first where there is only one
  };

  const std::vector<Instruction>& code() const { return code_; }
  const std::vector<Rational>& constants() const { return constants_; }
  std::uint32_t root() const { return static_cast<std::uint32_t>(code_.size() - 1); }
  Sort sort() const;
  /// Slots of its symbols, each once, ascending.
  std::vector<std::size_t> slots() const;

  /// The slot of every symbol; nothing for a name that does not exist.
  using Resolver = std::function<std::optional<std::size_t>(std::string_view)>;
  /// Compiles an expression. Each symbol must resolve; see unknown_symbols().
  Program(const Expression& expression, const Resolver& resolver);

 private:
  std::uint32_t emit(const Expression& expression, const Resolver& resolver);
  std::uint32_t push(Instruction instruction);

  std::vector<Instruction> code_;
  std::vector<Rational> constants_;
};

}  // namespace slipproof
