#include "mechanics/kernel/random_problem.hpp"

#include <utility>

namespace slipproof::test {

namespace {

AffineForm scaled(const Rational& factor, AffineForm form) {
  form.constant *= factor;
  for (Rational& c : form.coefficients) c *= factor;
  return form;
}

using Law = ElementKind::Law;

}  // namespace

AffineForm RandomProblems::unit(std::size_t unknown) const {
  AffineForm form{0, std::vector<Rational>(problem_.unknowns + 1)};
  form.coefficients[unknown] = 1;
  return form;
}

/// An acceleration of a contact or a link; one of those before, now and then.
AffineForm RandomProblems::direction() {
  if (!directions_.empty() && one_in(4)) return directions_[engine_() % directions_.size()];
  AffineForm form{one_in(4) ? integer(-2, 2) : 0, std::vector<Rational>(problem_.unknowns + 1)};
  for (std::size_t i = 0; i < accelerations_; ++i) form.coefficients[i] = integer(-2, 2);
  if (problem_.has_load && one_in(5)) form.coefficients.back() = integer(-1, 1);
  directions_.push_back(form);
  return form;
}

ElementKind RandomProblems::kind() {
  ElementKind result;
  result.law = one_in(4) ? Law::frictionless : one_in(4) ? Law::limited : Law::coulomb;
  if (result.law != Law::limited) result.bilateral = one_in(5);
  if (result.law != Law::frictionless && one_in(4)) {
    result.start = one_in(2) ? ElementKind::Start::slides_forward : ElementKind::Start::slides_backward;
  }
  if (result.law != Law::limited && !result.bilateral && one_in(10)) result.start = ElementKind::Start::open;
  if (result.law == Law::coulomb && !result.bilateral && one_in(8)) result.lifts = false;
  return result;
}

/// A force that acts along a direction by virtual work; now and then along another one.
void RandomProblems::add_force(const AffineForm& along) {
  for (std::size_t i = 0; i < accelerations_; ++i) {
    problem_.equations[i].coefficients[used_] = one_in(30) ? Rational(integer(-2, 2)) : -along.coefficients[i];
  }
  problem_.forces.push_back(unit(used_++));
}

void RandomProblems::add_element(ProblemElement& e) {
  const std::size_t first = used_;
  if (e.kind.law != Law::limited) {
    e.gap = direction();
    problem_.accelerations.push_back(e.gap);
    add_force(e.gap);
    e.normal = unit(first);
  }
  if (e.kind.law == Law::frictionless) return;
  e.slip = direction();
  problem_.accelerations.push_back(e.slip);
  e.tangent = unit(used_);
  add_force(e.slip);
  const Rational kinetic(integer(0, 4), 2), ratio = one_in(3) ? Rational(integer(2, 4), 2) : Rational(1);
  if (e.kind.law == Law::coulomb) {
    e.kinetic_limit = scaled(kinetic, e.normal);
  } else {
    e.kinetic_limit = AffineForm{kinetic, std::vector<Rational>(problem_.unknowns + 1)};
    if (problem_.has_load && one_in(3)) e.kinetic_limit.coefficients.back() = integer(-1, 1);
    if (first > accelerations_ && one_in(3)) e.kinetic_limit.coefficients[first - 1] = Rational(1, 2);
  }
  e.static_limit = scaled(ratio, e.kinetic_limit);
}

ForceInterval RandomProblems::domain() {
  if (one_in(2)) return {};
  if (one_in(8)) return ForceInterval::point(integer(-2, 2));
  std::optional<Rational> lower, upper;
  if (!one_in(3)) lower = integer(-3, 0);
  if (!one_in(3)) upper = integer(1, 3);
  const bool lower_closed = one_in(2);
  return ForceInterval::between(lower, lower_closed, upper, one_in(2));
}

/// M a = f, with M positive definite, or semidefinite now and then.
void RandomProblems::add_motion() {
  std::vector<std::vector<int>> root(accelerations_, std::vector<int>(accelerations_));
  for (auto& row : root) {
    for (int& x : row) x = integer(-1, 1);
  }
  const int own = one_in(4) ? 0 : integer(1, 2);
  for (std::size_t i = 0; i < accelerations_; ++i) {
    AffineForm equation{integer(-3, 3), std::vector<Rational>(problem_.unknowns + 1)};
    for (std::size_t j = 0; j < accelerations_; ++j) {
      int entry = i == j ? own : 0;
      for (std::size_t k = 0; k < accelerations_; ++k) entry += root[i][k] * root[j][k];
      equation.coefficients[j] = entry;
    }
    if (problem_.has_load) equation.coefficients.back() = integer(-1, 1);
    problem_.equations.push_back(std::move(equation));
    problem_.accelerations.push_back(unit(i));
  }
}

FrictionProblem RandomProblems::problem() {
  problem_ = {};
  directions_.clear();
  accelerations_ = used_ = static_cast<std::size_t>(integer(1, 3));
  problem_.elements.resize(static_cast<std::size_t>(integer(1, 3)));
  const bool link = one_in(5);
  problem_.unknowns = accelerations_ + (link ? 1 : 0);
  for (ProblemElement& e : problem_.elements) {
    e.kind = kind();
    problem_.unknowns += e.kind.law == Law::coulomb ? 2 : 1;
  }
  problem_.has_load = !one_in(4);
  if (problem_.has_load) problem_.load_domain = domain();
  add_motion();
  for (ProblemElement& e : problem_.elements) add_element(e);
  if (link) {
    const AffineForm zero = direction();
    add_force(zero);
    problem_.equations.push_back(zero);
  }
  return problem_;
}

}  // namespace slipproof::test
