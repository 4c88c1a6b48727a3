#include "mechanics/elements/friction_problem.hpp"

namespace slipproof {

std::vector<ElementKind> kinds_of(const FrictionProblem& problem) {
  std::vector<ElementKind> kinds;
  for (const ProblemElement& element : problem.elements) kinds.push_back(element.kind);
  return kinds;
}

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

}  // namespace slipproof
