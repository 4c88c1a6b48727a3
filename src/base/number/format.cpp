#include "base/number/format.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <functional>
#include <stdexcept>

namespace slipproof {

namespace {

/// floor(log10 |x|), or one less: a first guess from the lengths in bits.
long decimal_exponent_guess(const Rational& x) {
  const long bits = static_cast<long>(numerator(x).bits()) - static_cast<long>(denominator(x).bits()) - 1;
  // log10(2) = 0.30102999...; rounded down for both signs.
  return bits >= 0 ? bits * 30102 / 100000 : -((-bits * 30103 + 99999) / 100000);
}

/// |x| / 10^exponent = quotient + remainder / divisor.
struct Scaled {
  Scaled(const Rational& x, long exponent) : divisor(denominator(x)) {
    Integer dividend = abs(numerator(x));
    (exponent < 0 ? dividend : divisor) *= pow(Integer(10), static_cast<unsigned long>(std::labs(exponent)));
    parts = divide(dividend, divisor);
  }

  Integer divisor;
  QuotientAndRemainder parts;
};

/// A number in three digits that is still a bound: `factor` moves it while `beyond` says that printing lost the bound.
template <class Beyond>
std::string three_digits(double x, double factor, const Beyond& beyond) {
  if (x == 0) return "0";
  std::string text = fmt::format("{:.2e}", x);
  for (double step = x * factor; beyond(std::strtod(text.c_str(), nullptr), x); step *= factor) {
    text = fmt::format("{:.2e}", step);
  }
  return text;
}

}  // namespace

std::string exact_text(const Rational& x) {
  return x.str();
}

std::string decimal_text(const Rational& x, int digits) {
  if (digits < 1) throw std::invalid_argument("decimal_text: at least one significant digit");
  if (x.is_zero()) return "0";
  const Integer limit = pow(Integer(10), static_cast<unsigned long>(digits));
  long exponent = decimal_exponent_guess(x);
  Scaled scaled(x, exponent + 1 - digits);
  while (scaled.parts.quotient >= limit) scaled = Scaled(x, ++exponent + 1 - digits);
  auto& [quotient, remainder] = scaled.parts;
  const int half = (remainder << 1).compare(scaled.divisor);
  if (half > 0 || (half == 0 && quotient.is_odd())) ++quotient;
  if (quotient == limit) {
    quotient /= 10;
    ++exponent;
  }

  std::string significand = quotient.str();
  significand.erase(significand.find_last_not_of('0') + 1);
  const std::string minus = sign(x) < 0 ? "-" : "";
  if (exponent < -4 || exponent >= digits) {
    if (significand.size() > 1) significand.insert(1, ".");
    const std::string magnitude = std::to_string(std::labs(exponent));
    return minus + significand + (exponent < 0 ? "e-" : "e+") + (magnitude.size() < 2 ? "0" : "") + magnitude;
  }
  if (exponent < 0) return minus + "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + significand;
  const auto integer_digits = static_cast<std::size_t>(exponent) + 1;
  if (significand.size() <= integer_digits) return minus + significand.append(integer_digits - significand.size(), '0');
  return minus + significand.insert(integer_digits, ".");
}

std::string at_most(double bound) {
  return three_digits(bound, 1 + 1e-3, std::less<>());
}

std::string at_least(double bound) {
  return three_digits(bound, 1 - 1e-3, std::greater<>());
}

std::string counted(std::uint64_t count, std::string_view noun) {
  return std::to_string(count) + ' ' + std::string(noun) + (count == 1 ? "" : "s");
}

}  // namespace slipproof
