// Polynomials along a line of bicycles whose zeros matter, collected while formulas are evaluated.
#pragma once

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "claims/lines/line_function.hpp"

namespace slipproof {

/// Collects polynomials in t. What depends on the force is alpha(t) + beta(t) F: its zero in F is an end of an interval
/// of forces, and critical are the t at which it goes to infinity (beta = 0) or meets another one: two ends
/// -alpha/beta are in the same order as long as alpha1 beta2 - alpha2 beta1 does not vanish.
class CriticalSet {
 public:
  /// Groups of forms whose ends meet: those of group 0 meet all, those of another one meet these and each other.
  void begin_group(std::size_t group) {
    group_ = group;
    if (group >= groups_.size()) groups_.resize(group + 1);
  }

  void add(const IntegerPolynomial& p);
  void add(const Affine<IntegerPolynomial>& form);
  /// A quantity that is compared with 0, or divided by: numerator and denominator.
  void add(const LineFunction& x);
  /// For limits: all coefficients, since the force stands for what grows.
  void add_coefficients(const LineFunction& x);
  /// A polynomial whose sign decides which operand of a min, max or abs is meant.
  void add_order(const IntegerPolynomial& p);
  /// The same where that changes with the force: the number of this difference among those that do.
  std::size_t branch_of(const LineFunction& difference);

  const std::set<IntegerPolynomial>& orders() const { return orders_; }
  std::size_t branches() const { return branches_.size(); }
  /// All of them, those of meeting ends included.
  std::set<IntegerPolynomial> polynomials() const;

 private:
  using Form = std::pair<IntegerPolynomial, IntegerPolynomial>;
  void add(const ForcePolynomial& p);

  std::set<IntegerPolynomial> polynomials_, orders_;
  std::vector<std::set<Form>> groups_{1};
  std::size_t group_ = 0;
  std::vector<ForcePolynomial> branches_;
};

/// How an Evaluator computes along a line. It records what is divided by; which of two numbers is greater may change
/// along the line, and is told as it is at one place of it; where it changes with the force, as `branches` has it.
struct LineField {
  CriticalSet* found;
  Rational here;
  unsigned branches = 0;     ///< bit by bit: the differences of branch_of() that are negative
  bool at_infinity = false;  ///< the force stands for what grows beyond all bounds

  LineFunction constant(const Rational& value) const { return LineFunction(value); }
  bool is_zero(const LineFunction& divisor) const;
  std::optional<int> compare(const LineFunction& x, const LineFunction& y) const;
};

}  // namespace slipproof
