#include "contact/problem/yardstick.hpp"

#include <algorithm>

namespace slipproof {

bool is_nearer(const Distance& solution, const Distance& other, const Rational& tolerance) {
  const bool accurate = solution.relative <= tolerance;
  if (accurate != (other.relative <= tolerance)) return accurate;
  return solution.scaled < other.scaled;
}

void Yardsticks::take(std::size_t kind, const Rational& quantity) {
  largest_[kind] = std::max(largest_[kind], Rational(abs(quantity)));
}

bool compare(const ComparedComponent& component, Distance& distance) {
  const Rational error = abs(component.answer - component.exact);
  if (error.is_zero()) return false;
  const Rational size = abs(component.exact);
  const Rational& yardstick = component.yardstick;
  const Rational scale = component.open && !yardstick.is_zero() ? yardstick : std::max(size, yardstick);
  const Rational scaled = scale.is_zero() ? Rational(1) : Rational(error / scale);
  const Rational relative = component.open || size.is_zero() ? scaled : Rational(error / size);
  distance.scaled = std::max(distance.scaled, scaled);
  if (relative <= distance.relative) return false;
  distance.relative = relative;
  return true;
}

std::vector<Rational> nearest_solution(const std::vector<OpenComponent>& components,
                                       const std::vector<AffineForm>& conditions, std::size_t parameters,
                                       Effort& effort) {
  // Least s with |form(t) - answer| <= s * yardstick for each component: variables t, then s.
  std::vector<AffineForm> constraints = conditions;
  for (AffineForm& form : constraints) form.coefficients.emplace_back(0);
  for (const OpenComponent& component : components) {
    for (const int sign : {1, -1}) {
      AffineForm form{sign * (component.form.constant - component.answer), {}};
      for (const Rational& slope : component.form.coefficients) form.coefficients.push_back(sign * slope);
      form.coefficients.push_back(component.yardstick.is_zero() ? Rational(1) : component.yardstick);
      constraints.push_back(std::move(form));
    }
  }
  AffineForm least{0, std::vector<Rational>(parameters + 1)};
  if (!components.empty()) least.coefficients.back() = 1;
  std::vector<Rational> t = minimize(least, constraints, effort).x;
  t.resize(parameters);
  return t;
}

}  // namespace slipproof
