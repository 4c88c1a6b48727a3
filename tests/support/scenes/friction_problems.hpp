// Problems for the kernel in src/mechanics/kernel: bicycles by the equations of proofs/MODEL.md.
#pragma once

#include "mechanics/elements/friction_problem.hpp"
#include "support/bicycle/linear_form.hpp"

namespace slipproof::test {

inline AffineForm to_form(const LinearForm<Rational>& form) {
  return {form.constant, {form.coefficients.begin(), form.coefficients.end()}};
}

/// A bicycle with the force F as its load. Accelerations are a, a_y, phi, eps2, eps3 and the gaps and slips; forces S2,
/// S3, N2, N3: the order of the quantities in support/bicycle/contact_mode.hpp.
inline FrictionProblem bicycle_problem(const Bicycle<Rational>& p, const Road<Rational>& road, ForceKind kind) {
  using Form = LinearForm<Rational>;
  const auto x = [](std::size_t i) { return Form::variable(i); };
  const Unknowns<Form> u{x(0), x(1), x(2), x(3), x(4), x(5), x(6), x(7), x(8), x(9), x(10)};
  FrictionProblem problem;
  problem.unknowns = unknown_count;
  problem.has_load = true;
  for (const Form& e : equations_of_motion(p, road, kind, u, x(unknown_count))) problem.equations.push_back(to_form(e));
  const Motion<Form> motion = motion_of(p, u);
  for (const Quantity q : all_quantities()) {
    const bool force = q >= Quantity::S2 && q <= Quantity::N3;
    (force ? problem.forces : problem.accelerations).push_back(to_form(motion[q]));
  }
  problem.accelerations.push_back(to_form(u.eps1));
  for (const Wheel wheel : {Wheel::rear, Wheel::front}) {
    ProblemElement e;
    e.kind.lifts = p.J.has_value();
    const bool rear = wheel == Wheel::rear;
    e.gap = to_form(gap(p, u, wheel));
    e.slip = to_form(slip(p, u, wheel));
    e.normal = to_form(rear ? u.N2 : u.N3);
    e.tangent = to_form(rear ? u.S2 : u.S3);
    e.static_limit = e.kinetic_limit = to_form(road.f * (rear ? u.N2 : u.N3));
    problem.elements.push_back(std::move(e));
  }
  return problem;
}

}  // namespace slipproof::test
