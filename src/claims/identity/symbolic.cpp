#include "claims/identity/symbolic.hpp"

#include <string>

namespace slipproof {

bool SymbolicNumber::is_zero() const {
  return polynomial() != nullptr ? polynomial()->is_zero() : integer() == 0;
}

bool SymbolicNumber::is_one() const {
  return polynomial() != nullptr ? polynomial()->is_one() : integer() == 1;
}

MultiPolynomial SymbolicNumber::in(const PolynomialRing& ring) const {
  return polynomial() != nullptr ? *polynomial() : MultiPolynomial(ring, Rational(integer()));
}

SymbolicNumber SymbolicNumber::operator-() const {
  if (polynomial() == nullptr) return -integer();
  return -*polynomial();
}

SymbolicNumber operator+(const SymbolicNumber& x, const SymbolicNumber& y) {
  const MultiPolynomial* const some = x.polynomial() != nullptr ? x.polynomial() : y.polynomial();
  if (some == nullptr) return x.integer() + y.integer();
  return x.in(some->ring()) + y.in(some->ring());
}

SymbolicNumber operator*(const SymbolicNumber& x, const SymbolicNumber& y) {
  const MultiPolynomial* const some = x.polynomial() != nullptr ? x.polynomial() : y.polynomial();
  if (some == nullptr) return x.integer() * y.integer();
  return x.in(some->ring()) * y.in(some->ring());
}

void cancel(SymbolicNumber& x, SymbolicNumber& y) {
  const MultiPolynomial* const some = x.polynomial() != nullptr ? x.polynomial() : y.polynomial();
  if (some == nullptr || y.is_one()) return;
  MultiPolynomial numerator = x.in(some->ring()), denominator = y.in(some->ring());
  if (!denominator.is_constant()) {
    if (const auto divisor = numerator.common_divisor(denominator)) {
      numerator = *numerator.divided_by(*divisor);
      denominator = *denominator.divided_by(*divisor);
    }
  }
  const Rational lead = denominator.leading_coefficient();
  x = numerator.scaled(1 / lead);
  y = denominator.scaled(1 / lead);
}

std::unique_ptr<const PolynomialRing> ring_of(const Scope& scope, const std::vector<std::size_t>& slots) {
  std::vector<std::string> names;
  for (const std::size_t slot : slots) names.push_back(scope.slots[slot].name);
  return std::make_unique<const PolynomialRing>(std::move(names), MonomialOrder::degree_reverse_lexicographic);
}

SymbolicEvaluator symbolic(const Scope& scope, const std::vector<std::size_t>& slots, const PolynomialRing& ring) {
  SymbolicEvaluator evaluator(scope, FractionField{&ring});
  for (std::size_t i = 0; i < slots.size(); ++i) {
    evaluator.set(slots[i], ReducedFraction(SymbolicNumber(MultiPolynomial::variable(ring, i))));
  }
  return evaluator;
}

}  // namespace slipproof
