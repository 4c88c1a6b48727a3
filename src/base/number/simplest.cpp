#include "base/number/simplest.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace slipproof {

namespace {

Integer floor_of(const Rational& x) {
  const Integer &n = numerator(x), &d = denominator(x);
  Integer q = n / d;  // towards zero
  if (n < 0 && q * d != n) --q;
  return q;
}

/// Smallest denominator, then smallest value, strictly between 0 <= lower and upper (no value: infinite).
Rational simplest_positive(const Rational& lower, const std::optional<Rational>& upper) {
  const Integer whole = floor_of(lower);
  const Rational next(whole + 1);
  if (!upper || next < *upper) return next;
  // No integer strictly between: both ends have the same integer part, or upper is the next integer. The ends turn
  // round under 1/x.
  const Rational low = lower - Rational(whole), high = *upper - Rational(whole);
  const Rational inner = simplest_positive(1 / high, low.is_zero() ? std::nullopt : std::optional<Rational>(1 / low));
  return Rational(whole) + 1 / inner;
}

}  // namespace

Integer height(const Rational& x) {
  const Integer n = abs(numerator(x)), d = denominator(x);
  return n > d ? n : d;
}

Rational simplest_between(const std::optional<Rational>& lower, const std::optional<Rational>& upper) {
  if (lower && upper && *lower >= *upper) throw std::invalid_argument("nothing lies between the ends");
  if ((!lower || *lower < 0) && (!upper || *upper > 0)) return 0;
  if (lower && *lower >= 0) return simplest_positive(*lower, upper);
  return -simplest_positive(-*upper, lower ? std::optional<Rational>(-*lower) : std::nullopt);
}

bool Complexity::operator<(const Complexity& other) const {
  return std::tie(height, non_one, sum) < std::tie(other.height, other.non_one, other.sum);
}

Complexity complexity(const std::vector<Rational>& values) {
  Complexity c;
  for (const Rational& value : values) {
    const Integer h = height(value);
    c.height = std::max(c.height, h);
    c.sum += h;
    if (value != 1) ++c.non_one;
  }
  return c;
}

bool much_simpler(const std::vector<Rational>& values, const std::vector<Rational>& others) {
  return 2 * complexity(values).height <= complexity(others).height;
}

std::vector<Rational> numbers_up_to(int h) {
  std::vector<Rational> result;
  for (int top = 1; top <= h; ++top) {
    for (int other = 0; other <= top; ++other) {
      for (const auto& [n, d] : {std::pair(top, other), std::pair(other, top)}) {
        if (d == 0) continue;
        const Rational x(n, d);
        for (const Rational& value : {x, Rational(-x)}) {
          if (std::find(result.begin(), result.end(), value) == result.end()) result.push_back(value);
        }
      }
    }
  }
  std::swap(*std::find(result.begin(), result.end(), 1), result.front());
  return result;
}

std::vector<Rational> simpler_numbers(const Rational& value, int h) {
  std::vector<Rational> result = numbers_up_to(h);
  const Rational step(Integer(1), 4 * denominator(value));
  for (const Rational& radius : {abs(value) / 2, abs(value) / 4, abs(value) / 16, step}) {
    if (!radius.is_zero()) result.push_back(simplest_between(Rational(value - radius), Rational(value + radius)));
  }
  return result;
}

}  // namespace slipproof
