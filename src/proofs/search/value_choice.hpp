// Values of one variable, as conditions on it alone allow.
#pragma once

#include <optional>
#include <random>
#include <vector>

#include "proofs/statement/formula.hpp"

namespace slipproof::prove {

struct Condition {
  Polynomial p;
  Sign sign;
  bool either_sign = false;  ///< p != 0

  bool is_equation() const { return sign == Sign::zero; }
  bool holds_at(const Rational& value) const {
    if (either_sign) return value != 0;
    return sign == Sign::zero ? value == 0 : sign == Sign::positive ? value > 0 : value >= 0;
  }
};

/// Simple values, at random.
class ValueChoice {
 public:
  /// With `roots`, nonlinear conditions count, too: values are chosen between their roots, and at them.
  ValueChoice(const Ring& ring, std::mt19937_64& random, bool roots) : ring_(ring), random_(random), roots_(roots) {}

  /// A value that the conditions allow; nothing if none was found.
  std::optional<Rational> choose(std::size_t v, const std::vector<Condition>& conditions);

 private:
  /// A value for a variable without conditions, sometimes a very small or large one.
  Rational anything();
  Rational simple();
  /// Anything between the ends, if there are any.
  Rational between(const std::optional<Rational>& lower, const std::optional<Rational>& upper);
  /// One of the values between or at the roots of the conditions in v alone, at which these hold; nothing if there is
  /// none.
  std::optional<Rational> choose_by_roots(std::size_t v, const std::vector<const Condition*>& conditions);

  const Ring& ring_;
  std::mt19937_64& random_;
  bool roots_;
};

}  // namespace slipproof::prove
