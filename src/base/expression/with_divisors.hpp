// Values together with all their divisors.
//
// Quotients of polynomials cancel: F/F becomes 1, and 1/(1/F) becomes F. A claim does not cancel: where a divisor is 0
// it has no value (proofs/MEANING.md, Values). So each value carries all divisors of the expression that it comes from,
// and code that needs its truth first checks where these vanish. This assumes that a value of the type below is exact
// wherever its divisors are not 0.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace slipproof {

/// Requires of Quotient: + - * /, equality by value, and divisor_of(quotient), which returns a Divisor with == that
/// vanishes exactly where the quotient does, or nothing for a constant.
template <class Quotient, class Divisor>
class WithDivisors {
 public:
  WithDivisors(Quotient value) : value_(std::move(value)) {}  // NOLINT: quotients belong

  const Quotient& value() const { return value_; }
  /// The distinct divisors that are not constant.
  const std::vector<Divisor>& divisors() const { return divisors_; }

  friend WithDivisors operator+(const WithDivisors& x, const WithDivisors& y) { return {x.value_ + y.value_, x, y}; }
  friend WithDivisors operator-(const WithDivisors& x) { return {-x.value_, x, x}; }
  friend WithDivisors operator-(const WithDivisors& x, const WithDivisors& y) { return {x.value_ - y.value_, x, y}; }
  friend WithDivisors operator*(const WithDivisors& x, const WithDivisors& y) { return {x.value_ * y.value_, x, y}; }
  /// y must not be zero everywhere.
  friend WithDivisors operator/(const WithDivisors& x, const WithDivisors& y) {
    WithDivisors quotient(x.value_ / y.value_, x, y);
    if (auto divisor = divisor_of(y.value_)) quotient.add(std::move(*divisor));
    return quotient;
  }
  /// The same value, defined only where y is, too: max(x, y) and y^0 have a value only if all operands do.
  WithDivisors beside(const WithDivisors& y) const { return {value_, *this, y}; }
  /// Restricts the value to where the divisor is not 0.
  void add(Divisor divisor) {
    if (std::find(divisors_.begin(), divisors_.end(), divisor) == divisors_.end()) {
      divisors_.push_back(std::move(divisor));
    }
  }

 private:
  WithDivisors(Quotient value, const WithDivisors& x, const WithDivisors& y)
      : value_(std::move(value)), divisors_(x.divisors_) {
    if (&x == &y) return;
    for (const Divisor& divisor : y.divisors_) add(divisor);
  }

  Quotient value_;
  std::vector<Divisor> divisors_;
};

}  // namespace slipproof
