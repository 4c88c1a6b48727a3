#include "mechanics/lines/line_function.hpp"

#include <algorithm>

namespace slipproof {

namespace {

void trim(ForcePolynomial& p) {
  while (!p.empty() && p.back().is_zero()) p.pop_back();
}

ForcePolynomial product(const ForcePolynomial& p, const ForcePolynomial& q) {
  if (p.empty() || q.empty()) return {};
  ForcePolynomial result(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) result[i + j] = std::move(result[i + j]) + p[i] * q[j];
  }
  return result;
}

ForcePolynomial sum(ForcePolynomial p, const ForcePolynomial& q) {
  p.resize(std::max(p.size(), q.size()));
  for (std::size_t i = 0; i < q.size(); ++i) p[i] = std::move(p[i]) + q[i];
  trim(p);
  return p;
}

ForcePolynomial constant_polynomial(const Integer& x) {
  return x.is_zero() ? ForcePolynomial{} : ForcePolynomial{IntegerPolynomial(x)};
}

}  // namespace

LineFunction::LineFunction(const Rational& constant)
    : numerator_(constant_polynomial(slipproof::numerator(constant))),
      denominator_{IntegerPolynomial(slipproof::denominator(constant))} {}

LineFunction::LineFunction(IntegerPolynomial polynomial) : denominator_{IntegerPolynomial(1)} {
  if (!polynomial.is_zero()) numerator_.push_back(std::move(polynomial));
}

LineFunction::LineFunction(ForcePolynomial numerator, ForcePolynomial denominator)
    : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
  trim(numerator_);
  cancel();
}

LineFunction::LineFunction(const Affine<IntegerPolynomial>& numerator, IntegerPolynomial denominator)
    : LineFunction(ForcePolynomial{numerator.alpha, numerator.beta}, ForcePolynomial{std::move(denominator)}) {}

LineFunction LineFunction::linear(const Rational& constant, const Rational& slope) {
  const Integer &n = slipproof::denominator(constant), &m = slipproof::denominator(slope);
  IntegerPolynomial line(slipproof::numerator(constant) * m, slipproof::numerator(slope) * n);
  return {ForcePolynomial{std::move(line)}, ForcePolynomial{IntegerPolynomial(n * m)}};
}

void LineFunction::cancel() {
  IntegerPolynomial common;
  for (const ForcePolynomial* part : {&denominator_, &numerator_}) {
    for (const IntegerPolynomial& coefficient : *part) {
      common = gcd(common, coefficient);
      if (common.is_one()) return;
    }
  }
  for (ForcePolynomial* part : {&denominator_, &numerator_}) {
    for (IntegerPolynomial& coefficient : *part) coefficient = exact_quotient(coefficient, common);
  }
}

LineFunction operator+(const LineFunction& x, const LineFunction& y) {
  if (x.is_zero()) return y;
  if (y.is_zero()) return x;
  if (x.denominator_ == y.denominator_) return {sum(x.numerator_, y.numerator_), x.denominator_};
  return {sum(product(x.numerator_, y.denominator_), product(y.numerator_, x.denominator_)),
          product(x.denominator_, y.denominator_)};
}

LineFunction operator-(const LineFunction& x) {
  LineFunction result = x;
  for (IntegerPolynomial& coefficient : result.numerator_) coefficient = -std::move(coefficient);
  return result;
}

LineFunction operator*(const LineFunction& x, const LineFunction& y) {
  return {product(x.numerator_, y.numerator_), product(x.denominator_, y.denominator_)};
}

LineFunction operator/(const LineFunction& x, const LineFunction& y) {
  return {product(x.numerator_, y.denominator_), product(x.denominator_, y.numerator_)};
}

IntegerPolynomial least_common_multiple(const IntegerPolynomial& x, const IntegerPolynomial& y) {
  return y.is_one() ? x : x.is_one() ? y : exact_quotient(x * y, gcd(x, y));
}

IntegerPolynomial scaled(const IntegerPolynomial& x, const IntegerPolynomial& multiple,
                         const IntegerPolynomial& divisor) {
  if (divisor.is_one()) return multiple.is_one() ? x : x * multiple;
  return x.is_zero() ? x : exact_quotient(x * multiple, divisor);
}

}  // namespace slipproof
