// Small numbers: the height of a rational, the rational of least height in an interval, and how simple some together
// are.
#pragma once

#include <optional>
#include <vector>

#include "base/number/rational.hpp"

namespace slipproof {

/// The larger of |numerator| and denominator.
Integer height(const Rational& x);

/// The rational of smallest denominator, and then of smallest absolute value, strictly between the ends; no value: an
/// infinite end. Throws std::invalid_argument if there is nothing between them.
Rational simplest_between(const std::optional<Rational>& lower, const std::optional<Rational>& upper);

/// The complexity of a sample, compared lexicographically: the largest height of its values, the number of values other
/// than 1, the sum of heights.
struct Complexity {
  Integer height;
  std::size_t non_one = 0;
  Integer sum;

  bool operator<(const Complexity& other) const;
};
Complexity complexity(const std::vector<Rational>& values);

/// Whether somebody who checks by hand would rather take the first: its largest height is at most half of the other's.
bool much_simpler(const std::vector<Rational>& values, const std::vector<Rational>& others);

/// Rationals of height up to h, both signs and 0, simplest first; 1 is the first.
std::vector<Rational> numbers_up_to(int h);

/// Simpler candidates for a value: numbers up to a height, and the simplest ones near it.
std::vector<Rational> simpler_numbers(const Rational& value, int h);

}  // namespace slipproof
