// A mechanism in numbers: what the kernel solves. Mechanisms from files and contact problems (W, q, mu) both
// become one of these.
#pragma once

#include <vector>

#include "base/algebra/linear_program.hpp"
#include "mechanics/elements/element.hpp"
#include "mechanics/elements/force_interval.hpp"

namespace slipproof {

/// The forms of one element, in any type with sums. `gap` and `slip` are the accelerations of gap and slip. A contact
/// has gap and N, with friction also slip, S and its limits mu_s N and mu_k N; a friction element has slip, S and its
/// limits. The other members stay empty.
template <class Form>
struct ElementForms {
  ElementKind kind;
  Form gap, normal;    ///< N pushes the bodies apart
  Form slip, tangent;  ///< S acts along positive slip
  Form static_limit, kinetic_limit;
  /// In space `slip` and `tangent` are along the first direction, these along the second; and, of a contact that slides
  /// in the direction d, mu_k N d.
  Form second_slip, second_tangent;
  Form drag, second_drag;
};
using ProblemElement = ElementForms<AffineForm>;

/// Unknowns x_0, x_1, ... and a load: all forms are affine, with as many coefficients as there are unknowns and that of
/// the load after them (0 in a problem without one).
struct FrictionProblem {
  std::size_t unknowns = 0;
  std::vector<AffineForm> equations;      ///< vanish in every mode
  std::vector<AffineForm> accelerations;  ///< of a motion: unknown, gap and slip accelerations
  std::vector<AffineForm> forces;         ///< further quantities to report; may be undetermined
  std::vector<ProblemElement> elements;
  bool has_load = false;
  ForceInterval load_domain;  ///< the loads to consider

  std::size_t load_index() const { return unknowns; }
};

std::vector<ElementKind> kinds_of(const FrictionProblem& problem);

/// Calls visit(form) for each form of an element; those that it does not have are empty.
template <class Element, class Visit>
void visit_forms(Element& e, const Visit& visit) {
  for (auto* form : {&e.gap, &e.normal, &e.slip, &e.tangent, &e.static_limit, &e.kinetic_limit, &e.second_slip,
                     &e.second_tangent, &e.drag, &e.second_drag}) {
    visit(*form);
  }
}

/// Sums of forms of the same length.
AffineForm operator+(AffineForm x, const AffineForm& y);
AffineForm operator-(AffineForm x, const AffineForm& y);
AffineForm operator-(AffineForm x);

/// The left-hand side of an equation, which vanishes.
template <class Form>
Form form_of(const ElementForms<Form>& e, ElementState state, StateEquation equation) {
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
    case StateEquation::second_slip:
      return e.second_slip;
    case StateEquation::no_second:
      return e.second_tangent;
    case StateEquation::drags:
      return e.tangent + e.drag;
    case StateEquation::drags_second:
      return e.second_tangent + e.second_drag;
    case StateEquation::resists_backward:
      break;
  }
  return pulled ? e.tangent + e.kinetic_limit : e.tangent - e.kinetic_limit;
}

/// The form that a condition requires to be >= 0.
template <class Form>
Form form_of(const ElementForms<Form>& e, ElementState state, StateCondition condition) {
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
      return pulled ? -e.static_limit : e.static_limit;
    case StateCondition::kinetic_limit:
      break;
  }
  return pulled ? -e.kinetic_limit : e.kinetic_limit;
}

}  // namespace slipproof
