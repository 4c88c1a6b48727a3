// Evaluates programs at rational points. Truth values are tried in binary64 with error bounds first, and computed
// exactly only if the bounds leave them undecided. Numbers are always exact.
#pragma once

#include <vector>

#include "base/expression/evaluate.hpp"
#include "base/rounding/approximate.hpp"

namespace slipproof {

/// Comparisons that the error bounds do not decide are undecided; a quotient whose divisor may be 0 has an infinite
/// error.
template <>
struct FieldOf<Approximate> {
  Approximate constant(const Rational& value) const { return Approximate(value); }
  bool is_zero(const Approximate& x) const { return x.is_zero(); }
  std::optional<int> compare(const Approximate& x, const Approximate& y) const { return sure_sign(x - y); }
};

/// Gives the same truths and values as Evaluator<Rational>. Not for use by several threads.
class FilteredEvaluator {
 public:
  /// The scope must outlive the evaluator.
  explicit FilteredEvaluator(const Scope& scope) : approximate_(scope), exact_(scope) {}

  /// Forgets all values, and sets those of the symbols from `first` on; the values must stay valid until the next call.
  void set(std::size_t first, const std::vector<Rational>& values) {
    approximate_.reset();
    for (std::size_t k = 0; k < values.size(); ++k) approximate_.set(first + k, Approximate(values[k]));
    first_ = first;
    values_ = &values;
    is_exact_ = false;
  }

  Truth truth(const Program& program) {
    const Truth truth = approximate_.truth(program);
    return truth == Truth::undecided ? exact().truth(program) : truth;
  }
  Value<Rational> number(const Program& program) { return exact().number(program); }

 private:
  Evaluator<Rational>& exact() {
    if (!is_exact_ && values_ != nullptr) {
      exact_.reset();
      for (std::size_t k = 0; k < values_->size(); ++k) exact_.set(first_ + k, (*values_)[k]);
      is_exact_ = true;
    }
    return exact_;
  }

  Evaluator<Approximate> approximate_;
  Evaluator<Rational> exact_;
  std::size_t first_ = 0;
  const std::vector<Rational>* values_ = nullptr;
  bool is_exact_ = false;
};

}  // namespace slipproof
