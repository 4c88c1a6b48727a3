// Evaluation of programs over any field: rationals, rational functions of the force, polynomials of a prover.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/expression/program.hpp"

namespace slipproof {

/// The reason why there is no value.
enum class Failure : std::uint8_t {
  undefined,  ///< a division by zero
  undecided   ///< T cannot decide it, such as the sign of a function of F; or a symbol has no value
};

/// Truth in Kleene's logic: for any x, `no and x` is no, `yes or x` is yes.
enum class Truth : std::uint8_t { no, yes, undefined, undecided };

/// The result is `decisive` if either side is; `neutral` on one side gives the other side. For `and` these are no and
/// yes, for `or` yes and no.
inline Truth combine(Truth x, Truth y, Truth decisive, Truth neutral) {
  if (x == decisive || y == decisive) return decisive;
  if (x == neutral) return y;
  return y == Truth::undecided ? y : x;
}
inline Truth negation(Truth x) {
  return x == Truth::yes ? Truth::no : x == Truth::no ? Truth::yes : x;
}

template <class T>
struct Value {
  std::optional<T> number;
  Failure failure = Failure::undefined;  ///< why there is no number
};

/// The operations on T that the evaluator needs beyond + - * / and unary -. Specialise it, or pass an object with the
/// same members.
template <class T>
struct FieldOf {
  T constant(const Rational& value) const { return T(value); }
  bool is_zero(const T& x) const { return sign(x) == 0; }
  /// The sign of x - y: -1, 0 or +1; nothing if it is undecided.
  std::optional<int> compare(const T& x, const T& y) const { return sign(T(x - y)); }
};

template <>
struct FieldOf<Rational> {
  Rational constant(const Rational& value) const { return value; }
  bool is_zero(const Rational& x) const { return x.is_zero(); }
  std::optional<int> compare(const Rational& x, const Rational& y) const { return x.compare(y); }
};

/// The meaning of the slots of programs: given values, and definitions in terms of other slots (without cycles).
struct Scope {
  struct Slot {
    std::string name;
    std::optional<Program> definition;
  };
  std::vector<Slot> slots;
};

/// The values of one scope at one point. A definition is evaluated when it is first used, once; an undefined one
/// matters only where it is used. Not for use by several threads.
template <class T, class Field = FieldOf<T>>
class Evaluator {
 public:
  /// The scope must outlive the evaluator.
  explicit Evaluator(const Scope& scope, Field field = {})
      : scope_(&scope), field_(std::move(field)), cells_(scope.slots.size()) {}

  /// Gives a symbol its value. Definitions already evaluated keep theirs until reset().
  void set(std::size_t slot, const T& value) {
    cells_[slot].number = value;  // in the memory of an older one
    cells_[slot].known = true;
  }
  void set(std::size_t slot, T&& value) {
    cells_[slot].number = std::move(value);
    cells_[slot].known = true;
  }
  /// Forgets all values.
  void reset() {
    for (Cell& cell : cells_) cell.known = false;
  }

  /// The value of a symbol.
  Value<T> at(std::size_t slot) {
    const T* value = load(slot);
    return value ? Value<T>{*value} : Value<T>{std::nullopt, failure_};
  }
  Value<T> number(const Program& program) { return number(program, program.root()); }
  /// The value of one instruction, which must be a number.
  Value<T> number(const Program& program, std::uint32_t index) {
    std::optional<T> scratch;
    const T* value = number(program, index, scratch);
    return value ? Value<T>{*value} : Value<T>{std::nullopt, failure_};
  }
  Truth truth(const Program& program) { return truth(program, program.root()); }
  const Field& field() const { return field_; }

 private:
  struct Cell {
    bool known = false;
    std::optional<T> number;
    Failure failure = Failure::undefined;
  };

  const T* fail(Failure failure) {
    failure_ = failure;
    return nullptr;
  }

  const T* load(std::size_t slot) {
    Cell& cell = cells_[slot];
    if (!cell.known) {
      const auto& definition = scope_->slots[slot].definition;
      if (!definition) return fail(Failure::undecided);
      Value<T> value = number(*definition);
      cell.number = std::move(value.number);
      cell.failure = value.failure;
      cell.known = true;
    }
    return cell.number ? &*cell.number : fail(cell.failure);
  }

  // Returns the value of an instruction, in place or in `scratch`. If there is none, returns null and sets failure_.
  const T* number(const Program& program, std::uint32_t index, std::optional<T>& scratch) {
    const Program::Instruction& instruction = program.code()[index];
    switch (instruction.operation) {
      case Operation::number:
        if constexpr (std::is_same_v<T, Rational>) return &program.constants()[instruction.first];
        return &scratch.emplace(field_.constant(program.constants()[instruction.first]));
      case Operation::symbol:
        return load(instruction.first);
      case Operation::negate:
      case Operation::power:
      case Operation::absolute:
      case Operation::signum:
        return unary(program, instruction, scratch);
      default:
        return binary(program, instruction, scratch);
    }
  }

  const T* unary(const Program& program, const Program::Instruction& instruction, std::optional<T>& scratch) {
    const T* x = number(program, instruction.first, scratch);
    if (!x) return nullptr;
    if (instruction.operation == Operation::negate) return &scratch.emplace(-*x);
    if (instruction.operation == Operation::power) return power(*x, instruction.exponent, scratch);
    const auto order = field_.compare(*x, field_.constant(Rational(0)));
    if (!order) return fail(Failure::undecided);
    if (instruction.operation == Operation::signum) {
      return &scratch.emplace(beside(field_.constant(Rational(*order)), T(*x)));
    }
    return *order < 0 ? &scratch.emplace(-*x) : x;
  }

  /// The value, undefined where the other one is, too; for types that keep their divisors.
  static T beside(T value, const T& other) {
    if constexpr (requires { value.beside(other); }) return value.beside(other);
    return value;
  }

  const T* power(T base, int exponent, std::optional<T>& scratch) {
    T result = beside(field_.constant(Rational(1)), base);
    if (exponent < 0) {
      if (field_.is_zero(base)) return fail(Failure::undefined);
      base = result / base;
    }
    for (unsigned n = static_cast<unsigned>(exponent < 0 ? -exponent : exponent); n != 0; n /= 2) {
      if (n % 2 == 1) result = result * base;
      if (n > 1) base = base * base;
    }
    return &scratch.emplace(std::move(result));
  }

  const T* binary(const Program& program, const Program::Instruction& instruction, std::optional<T>& scratch) {
    std::optional<T> left, right;
    const T* x = number(program, instruction.first, left);
    if (!x) return nullptr;
    const T* y = number(program, instruction.second, right);
    if (!y) return nullptr;
    switch (instruction.operation) {
      case Operation::add:
        return &scratch.emplace(*x + *y);
      case Operation::subtract:
        return &scratch.emplace(*x - *y);
      case Operation::multiply:
        return &scratch.emplace(*x * *y);
      case Operation::divide:
        return field_.is_zero(*y) ? fail(Failure::undefined) : &scratch.emplace(*x / *y);
      default: {
        const auto order = field_.compare(*x, *y);
        if (!order) return fail(Failure::undecided);
        const bool first = instruction.operation == Operation::minimum ? *order <= 0 : *order >= 0;
        return &scratch.emplace(first ? beside(*x, *y) : beside(*y, *x));
      }
    }
  }

  Truth without_value() const { return failure_ == Failure::undefined ? Truth::undefined : Truth::undecided; }

  Truth truth(const Program& program, std::uint32_t index) {
    const Program::Instruction& instruction = program.code()[index];
    switch (instruction.operation) {
      case Operation::truth:
        return instruction.truth ? Truth::yes : Truth::no;
      case Operation::logical_not:
        return negation(truth(program, instruction.first));
      case Operation::logical_and:
        return either(program, instruction, Truth::no, Truth::yes);
      case Operation::logical_or:
        return either(program, instruction, Truth::yes, Truth::no);
      default:
        return compare(program, instruction);
    }
  }

  Truth either(const Program& program, const Program::Instruction& instruction, Truth decisive, Truth neutral) {
    const Truth x = truth(program, instruction.first);
    return x == decisive ? x : combine(x, truth(program, instruction.second), decisive, neutral);
  }

  Truth compare(const Program& program, const Program::Instruction& instruction) {
    std::optional<T> left, right;
    const T* x = number(program, instruction.first, left);
    if (!x) return without_value();
    const T* y = number(program, instruction.second, right);
    if (!y) return without_value();
    const auto order = field_.compare(*x, *y);
    if (!order) return Truth::undecided;
    return holds(instruction.relation, *order) ? Truth::yes : Truth::no;
  }

  const Scope* scope_;
  Field field_;
  std::vector<Cell> cells_;
  Failure failure_ = Failure::undefined;
};

}  // namespace slipproof
