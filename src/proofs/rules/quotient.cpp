#include "proofs/rules/quotient.hpp"

namespace slipproof::prove {

std::string Quotient::text() const {
  return denominator.is_constant() ? numerator.scaled(1 / denominator.constant()).text()
                                   : "(" + numerator.text() + ")/(" + denominator.text() + ")";
}

Quotient operator/(const Quotient& x, const Quotient& y) {
  return {x.numerator * y.denominator, x.denominator * y.numerator};
}

Quotient sum(const Quotient& x, const Quotient& y, const Rational& weight) {
  return {x.numerator * y.denominator + (y.numerator * x.denominator).scaled(weight), x.denominator * y.denominator};
}

Quotient substituted(const Polynomial& p, std::size_t variable, const Quotient& value) {
  return {substitute(p, variable, value.numerator, value.denominator), power(value.denominator, p.degree(variable))};
}

void cancel(Context& context, Quotient& value) {
  const Factorization factors = context.factored(value.denominator);
  for (const auto& [factor, exponent] : factors.factors) {
    for (unsigned i = 0; i < exponent; ++i) {
      const auto shorter = value.numerator.divided_by(factor);
      if (!shorter) break;
      value = {*shorter, *value.denominator.divided_by(factor)};
    }
  }
}

}  // namespace slipproof::prove
