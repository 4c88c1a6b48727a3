#include "floating/trade/truth.hpp"

#include <bit>
#include <cmath>

#include "base/number/binary64.hpp"

namespace slipproof {

namespace {

/// An expression with all signs made positive.
class Absolute {
 public:
  Absolute() = default;
  explicit Absolute(int constant) : value_(std::abs(constant)) {}
  static Absolute input(const Rational& x) {
    Absolute a;
    a.value_ = abs(x);
    return a;
  }
  const Rational& value() const { return value_; }
  friend Absolute operator+(const Absolute& x, const Absolute& y) { return input(x.value_ + y.value_); }
  friend Absolute operator*(const Absolute& x, const Absolute& y) { return input(x.value_ * y.value_); }
  friend Absolute operator-(const Absolute& x) { return x; }
  friend Absolute operator-(const Absolute& x, const Absolute& y) { return x + y; }

 private:
  Rational value_;
};

ReducedDynamics<Rational, Rational> exact_dynamics(const ForcedScene<Rational>& s) {
  return reduce<Rational, Rational>(s.bicycle, s.road, s.force_kind, s.F, Rational(1));
}

}  // namespace

Truth truth_of(const ForcedScene<Rational>& s) {
  Truth truth;
  truth.modes = exact_modes(s);
  if (std::popcount(truth.modes.consistent) != 1) return truth;
  const ContactMode mode = all_modes()[static_cast<std::size_t>(std::countr_zero(truth.modes.consistent))];
  const auto dynamics = exact_dynamics(s);
  const ReducedMotion<Rational, Rational> motion(dynamics, mode);
  if (motion.determinant().is_zero()) return truth;
  const auto magnitudes = tracked_dynamics<Absolute>(s);
  const ReducedMotion<Absolute, Absolute> absolute(magnitudes, mode);
  truth.only = mode;
  for (std::size_t i = 0; i < judged_quantities.size(); ++i) {
    const auto q = motion.quantity(judged_quantities[i]);
    const auto size = absolute.quantity(judged_quantities[i]);
    truth.values[i] = q.numerator / q.denominator;
    if (q.numerator.is_zero()) {
      truth.conditions[i] = HUGE_VAL;
    } else {
      truth.conditions[i] = nearest_binary64(
          Rational(size.numerator.value() / abs(q.numerator) + size.denominator.value() / abs(q.denominator)));
    }
  }
  return truth;
}

JudgedValues<Rational> exact_values(const ForcedScene<Rational>& s, ContactMode mode) {
  const auto dynamics = exact_dynamics(s);
  const ReducedMotion<Rational, Rational> motion(dynamics, mode);
  JudgedValues<Rational> values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto q = motion.quantity(judged_quantities[i]);
    values[i] = q.numerator / q.denominator;
  }
  return values;
}

}  // namespace slipproof
