#include "contact/enclosure/conditions.hpp"

#include <array>

#include "base/number/binary64.hpp"

namespace slipproof {

namespace {

/// Whether a number within `radius` of `center` is certain to be >= 0, and > 0.
struct Sign {
  bool not_negative = true, positive = true;
};

Sign sign_of(const Rational& center, double radius) {
  const double lower = enclose(center).lower;
  return {lower >= radius, lower > radius};
}

Sign both(Sign a, Sign b) {
  return {a.not_negative && b.not_negative, a.positive && b.positive};
}

/// least >= 0 and least^2 >= square
Sign reaches(const Rational& least, const Rational& square) {
  const int inside = least.sign() < 0 ? -1 : Rational(least * least - square).sign();
  return {inside >= 0, inside > 0};
}

class Conditions {
 public:
  Conditions(const MixedProblem& problem, const Enclosure& box)
      : problem_(problem), box_(box), x_(box.system.x_at(box.center)) {}

  Sign of(std::size_t k) const {
    if (box_.system.touches(k)) return {true, false};
    return box_.system.mode()[k] == ConeState::open ? open(k) : closed(k);
  }

 private:
  /// r_N >= 0, and r in the cone if it sticks.
  Sign closed(std::size_t k) const {
    const std::size_t first = problem_.normal(k), n = box_.system.unknown(first);
    Sign sign = sign_of(to_rational(box_.center[n]), box_.radius[n]);
    if (box_.system.mode()[k] == ConeState::slide) {
      const std::size_t s = box_.system.slip(k);
      return both(sign, sign_of(to_rational(box_.center[s]), box_.radius[s]));
    }
    if (problem_.mu[k] == 0 || problem_.dimension == 1) return sign;
    const std::array<int, 2> signs = slip_signs(box_.system.mode()[k]);
    const Rational least = to_rational(problem_.mu[k]) * (to_rational(box_.center[n]) - to_rational(box_.radius[n]));
    const bool cone = box_.system.mode()[k] == ConeState::stick && problem_.law.kind != FrictionLaw::box;
    Rational square = 0;
    for (std::size_t i = 1; i < problem_.dimension; ++i) {
      const std::size_t t = box_.system.unknown(first + i);
      const Rational T = abs(to_rational(box_.center[t])) + to_rational(box_.radius[t]);
      if (cone) {
        square += T * T;
      } else if (signs[i - 1] == 0) {  // of the box: |r_i| <= mu r_N
        sign = both(sign, sign_of(least - T, 0));
      } else {
        sign = both(sign, sign_of(signs[i - 1] * velocity(first + i), radius(first + i)));
      }
    }
    return cone ? both(sign, reaches(least, square)) : sign;
  }

  /// u_N >= 0, or for the associated law u_N >= mu |u_T|.
  Sign open(std::size_t k) const {
    const std::size_t first = problem_.normal(k);
    if (problem_.law.kind != FrictionLaw::associated || problem_.dimension == 1) {
      return sign_of(velocity(first), radius(first));
    }
    const Rational mu = to_rational(problem_.mu[k]);
    Rational square = 0;
    for (std::size_t i = 1; i < problem_.dimension; ++i) {
      const Rational T = abs(velocity(first + i)) + to_rational(radius(first + i));
      square += mu * mu * T * T;
    }
    return reaches(velocity(first) - to_rational(radius(first)), square);
  }

  Rational velocity(std::size_t row) const { return exact_row(problem_, row, x_); }
  double radius(std::size_t row) const { return row_radius(problem_, box_, row); }

  const MixedProblem& problem_;
  const Enclosure& box_;
  const std::vector<double> x_;
};

}  // namespace

std::vector<std::size_t> check_conditions(const MixedProblem& problem, Enclosure& box) {
  const Conditions conditions(problem, box);
  std::vector<std::size_t> failing;
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    const Sign sign = conditions.of(k);
    if (!sign.not_negative) failing.push_back(k);
    box.locally_unique = box.locally_unique && sign.positive;
  }
  return failing;
}

}  // namespace slipproof
