#include "base/number/rational.hpp"

#include <ostream>

namespace slipproof {

Rational::Rational(Integer dividend, Integer divisor)
    : numerator_(std::move(dividend)), denominator_(std::move(divisor)) {
  if (denominator_.is_zero()) throw std::overflow_error("division by zero");
  _fmpq_canonicalise(numerator_.flint(), denominator_.flint());
}

Rational::Rational(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) {
    numerator_ = Integer(text);
  } else {
    *this = Rational(Integer(text.substr(0, slash)), Integer(text.substr(slash + 1)));
  }
}

std::string Rational::str() const {
  return denominator_.is_one() ? numerator_.str() : numerator_.str() + '/' + denominator_.str();
}

double Rational::to_double() const {
  const GmpRational x(*this);
  return mpq_get_d(x.get());
}

Rational times_power_of_two(Integer x, long exponent) {
  if (exponent >= 0) return Rational(std::move(x) << static_cast<std::size_t>(exponent));
  return Rational(std::move(x), Integer(1) << static_cast<std::size_t>(-exponent));
}

Rational power_of_two(long exponent) {
  return times_power_of_two(1, exponent);
}

Rational abs(Rational x) {
  return x.sign() < 0 ? -std::move(x) : x;
}

Rational pow(const Rational& base, long exponent) {
  if (exponent < 0 && base.is_zero()) throw std::overflow_error("division by zero");
  fmpq_t power;
  fmpq_init(power);
  const fmpq value = base.flint();
  fmpq_pow_si(power, &value, exponent);
  Rational result(power);
  fmpq_clear(power);
  return result;
}

std::optional<Rational> exact_root(const Rational& x) {
  const auto over = exact_root(numerator(x)), under = exact_root(denominator(x));
  if (!over || !under) return std::nullopt;
  return Rational(*over, *under);
}

std::ostream& operator<<(std::ostream& out, const Rational& x) {
  return out << x.str();
}

GmpRational::GmpRational(const Rational& x) : numerator_(numerator(x)), denominator_(denominator(x)) {
  *mpq_numref(value_) = *numerator_.get();
  *mpq_denref(value_) = *denominator_.get();
}

}  // namespace slipproof
