#include "contact/complete/contacts.hpp"

#include <algorithm>
#include <cmath>

namespace slipproof {

namespace {

/// The exponent of the power of 2 near |x|; 0 for 0.
long exponent_of(const Rational& x) {
  const auto bits = [](const Integer& n) { return static_cast<long>(n.bits()); };
  return x.is_zero() ? 0 : bits(numerator(x)) - bits(denominator(x));
}

}  // namespace

ScaledContacts::ScaledContacts(const ExactContacts& original) : contacts(original) {
  const std::size_t n = original.size();
  std::vector<long> unit(n);
  for (std::size_t k = 0; k < original.contacts(); ++k) {
    Rational diagonal;
    for (std::size_t t = 0; t < original.dimension; ++t) {
      const std::size_t i = original.normal(k) + t;
      diagonal = std::max(diagonal, Rational(abs(original.W[i][i])));
    }
    for (std::size_t t = 0; t < original.dimension; ++t) unit[original.normal(k) + t] = -exponent_of(diagonal) / 2;
  }
  std::optional<long> largest;
  for (std::size_t i = 0; i < n; ++i) {
    if (!original.q[i].is_zero())
      largest = std::max(largest.value_or(-1'000'000), exponent_of(original.q[i]) + unit[i]);
  }
  const long common = largest.value_or(0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) contacts.W[i][j] *= power_of_two(unit[i] + unit[j]);
    contacts.q[i] *= power_of_two(unit[i] - common);
    force_unit.push_back(power_of_two(unit[i] + common));
    velocity_unit.push_back(power_of_two(common - unit[i]));
  }
}

IntegerContacts::IntegerContacts(const ExactContacts& contacts) {
  for (const auto& row : contacts.W) scale = common_denominator(row, scale);
  for (const auto& row : contacts.W) {
    std::vector<Integer>& own = matrix.emplace_back();
    for (const Rational& a : row) own.push_back(integer_times(a, scale));
  }
}

}  // namespace slipproof
