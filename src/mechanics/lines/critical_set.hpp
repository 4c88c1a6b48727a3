// The polynomials along a line of points whose zeros matter, collected while formulas are evaluated.
#pragma once

#include <compare>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "mechanics/lines/line_function.hpp"

namespace slipproof {

/// Collects polynomials in t. A number that depends on the force is alpha(t) + beta(t) F; its zero in F is an end of an
/// interval of forces. Critical are the t at which this end goes to infinity (beta = 0) or meets another end. Two ends
/// -alpha/beta keep their order while alpha1 beta2 - alpha2 beta1 does not vanish.
class CriticalSet {
 public:
  /// Begins a group of forms whose ends can meet. Forms of group 0 meet all others; forms of another group meet each
  /// other and those of group 0.
  void begin_group(std::size_t group) {
    group_ = group;
    if (group >= groups_.size()) groups_.resize(group + 1);
  }

  /// Begins a mode in the group: where ends of its forces meet each other is added by who knows them.
  void begin_mode() { ++mode_; }

  void add(const IntegerPolynomial& p);
  void add(const Affine<IntegerPolynomial>& form) { add(form, 0); }
  /// Adds an end of the mode's forces.
  void add_end(const Affine<IntegerPolynomial>& form) { add(form, mode_); }
  /// Adds numerator and denominator of a number that is compared with 0 or divided by.
  void add(const LineFunction& x);
  /// For limits: adds all coefficients, since the force then stands for the growing parameter.
  void add_coefficients(const LineFunction& x);
  /// Adds a polynomial whose sign decides which operand of a min, max or abs is taken.
  void add_order(const IntegerPolynomial& p);
  /// The same if the sign changes with the force: returns the index of this difference among those whose sign does.
  std::size_t branch_of(const LineFunction& difference);

  const std::set<IntegerPolynomial>& orders() const { return orders_; }
  std::size_t branches() const { return branches_.size(); }
  /// All polynomials, including those for ends that meet.
  std::set<IntegerPolynomial> polynomials() const;

 private:
  struct Form {
    IntegerPolynomial alpha, beta;
    std::size_t mode;  ///< whose forces end there; 0 for none
    std::weak_ordering operator<=>(const Form&) const = default;
  };
  void add(const ForcePolynomial& p);
  void add(const Affine<IntegerPolynomial>& form, std::size_t mode);

  std::set<IntegerPolynomial> polynomials_, orders_;
  std::vector<std::set<Form>> groups_{1};
  std::size_t group_ = 0, mode_ = 0;
  std::vector<ForcePolynomial> branches_;
};

/// Tells an Evaluator how to compute along a line. Records all divisors. Which of two numbers is greater may change
/// along the line; the answer is for one place on it, and if it changes with the force, `branches` decides.
struct LineField {
  CriticalSet* found;
  Rational here;
  unsigned branches = 0;     ///< one bit for each difference of branch_of(): whether it is negative
  bool at_infinity = false;  ///< the force stands for a parameter that grows without bound

  LineFunction constant(const Rational& value) const { return LineFunction(value); }
  bool is_zero(const LineFunction& divisor) const;
  std::optional<int> compare(const LineFunction& x, const LineFunction& y) const;
};

}  // namespace slipproof
