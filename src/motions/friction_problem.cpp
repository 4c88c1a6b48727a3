#include "motions/friction_problem.hpp"

namespace slipproof {

AffineForm operator+(AffineForm x, const AffineForm& y) {
  x.constant += y.constant;
  for (std::size_t i = 0; i < x.coefficients.size(); ++i) {
    if (!y.coefficients[i].is_zero()) x.coefficients[i] += y.coefficients[i];
  }
  return x;
}

AffineForm operator-(AffineForm x, const AffineForm& y) {
  x.constant -= y.constant;
  for (std::size_t i = 0; i < x.coefficients.size(); ++i) {
    if (!y.coefficients[i].is_zero()) x.coefficients[i] -= y.coefficients[i];
  }
  return x;
}

AffineForm operator-(AffineForm x) {
  x.constant = -x.constant;
  for (Rational& c : x.coefficients) c = -c;
  return x;
}

AffineForm form_of(const ProblemElement& e, ElementState state, StateEquation equation) {
  const bool pulled = is_pulled(state);
  switch (equation) {
    case StateEquation::gap:
      return e.gap;
    case StateEquation::slip:
      return e.slip;
    case StateEquation::no_normal:
      return e.normal;
    case StateEquation::no_tangent:
      return e.tangent;
    case StateEquation::resists_forward:
      return pulled ? e.tangent - e.kinetic_limit : e.tangent + e.kinetic_limit;
    case StateEquation::resists_backward:
      break;
  }
  return pulled ? e.tangent + e.kinetic_limit : e.tangent - e.kinetic_limit;
}

AffineForm form_of(const ProblemElement& e, ElementState state, StateCondition condition) {
  const bool pulled = is_pulled(state);
  switch (condition) {
    case StateCondition::pushes:
      return e.normal;
    case StateCondition::pulls:
      return -e.normal;
    case StateCondition::holds_forward:
      return (pulled ? -e.static_limit : e.static_limit) - e.tangent;
    case StateCondition::holds_backward:
      return (pulled ? -e.static_limit : e.static_limit) + e.tangent;
    case StateCondition::slips_forward:
      return e.slip;
    case StateCondition::slips_backward:
      return -e.slip;
    case StateCondition::opens:
      return e.gap;
    case StateCondition::static_limit:
      return e.static_limit;
    case StateCondition::kinetic_limit:
      break;
  }
  return e.kinetic_limit;
}

}  // namespace slipproof
