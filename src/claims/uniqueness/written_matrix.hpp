// Determinants whose entries are expressions. Those of mechanisms are small, and most entries are 0.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "base/expression/expression.hpp"

namespace slipproof {

/// A number as an expression, for an Evaluator; sums and products leave out 0 and 1.
class WrittenNumber {
 public:
  explicit WrittenNumber(const Rational& value) : expression_(make_number(value)) {}
  explicit WrittenNumber(Expression expression) : expression_(std::move(expression)) {}

  const Expression& expression() const { return expression_; }
  bool is_zero() const { return is(0); }

  friend WrittenNumber operator-(const WrittenNumber& x) {
    return x.is_zero() ? x : WrittenNumber(make(Operation::negate, {x.expression_}));
  }
  friend WrittenNumber operator+(const WrittenNumber& x, const WrittenNumber& y) {
    if (x.is_zero()) return y;
    return y.is_zero() ? x : WrittenNumber(make(Operation::add, {x.expression_, y.expression_}));
  }
  friend WrittenNumber operator-(const WrittenNumber& x, const WrittenNumber& y) {
    if (y.is_zero()) return x;
    return x.is_zero() ? -y : WrittenNumber(make(Operation::subtract, {x.expression_, y.expression_}));
  }
  friend WrittenNumber operator*(const WrittenNumber& x, const WrittenNumber& y) {
    if (x.is_zero() || y.is(1)) return x;
    if (y.is_zero() || x.is(1)) return y;
    return WrittenNumber(make(Operation::multiply, {x.expression_, y.expression_}));
  }
  friend WrittenNumber operator/(const WrittenNumber& x, const WrittenNumber& y) {
    return y.is(1) ? x : WrittenNumber(make(Operation::divide, {x.expression_, y.expression_}));
  }

 private:
  bool is(int number) const { return expression_->operation == Operation::number && expression_->number == number; }

  Expression expression_;
};

/// The order of two expressions is not known.
struct WrittenField {
  WrittenNumber constant(const Rational& value) const { return WrittenNumber(value); }
  bool is_zero(const WrittenNumber& x) const { return x.is_zero(); }
  std::optional<int> compare(const WrittenNumber& /*x*/, const WrittenNumber& /*y*/) const { return std::nullopt; }
};

/// Square, by rows.
using WrittenMatrix = std::vector<std::vector<WrittenNumber>>;

/// Laplace expansion along the row with the fewest entries; nothing if that takes more than a few thousand products.
std::optional<WrittenNumber> determinant_of(const WrittenMatrix& matrix);

}  // namespace slipproof
