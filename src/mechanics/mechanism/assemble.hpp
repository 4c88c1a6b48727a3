// Assembles the equations and elements of a mechanism, in any type of forms: numbers at one point, or programs for all
// points.
#pragma once

#include <string>
#include <vector>

#include "mechanics/elements/friction_problem.hpp"
#include "mechanics/mechanism/compiled.hpp"

namespace slipproof {

/// Fills in unknowns, equations, accelerations, forces and elements, in the orders that FrictionProblem and
/// ProblemMaker say. `forms` has form(CompiledForm, what), unit(unknown), and limit(Program, unknown, what): a
/// coefficient times an unknown; `what` is how messages call it. Problem has FrictionProblem's members, perhaps of
/// another type of forms. Linear in the size of the mechanism.
template <class Forms, class Problem>
class Assembly {
 public:
  Assembly(const Mechanism& mechanism, const CompiledMechanism& compiled, Forms& forms, Problem& problem)
      : mechanism_(mechanism), compiled_(compiled), forms_(forms), problem_(problem) {}

  void add_equations() {
    const std::size_t own = mechanism_.equations.size();
    for (std::size_t i = 0; i < compiled_.equations.size(); ++i) {
      const std::string& name = i < own ? mechanism_.equations[i].name : mechanism_.links[i - own].name;
      problem_.equations.push_back(forms_.form(compiled_.equations[i], "the equation " + name));
    }
  }

  void add_unknowns() {
    problem_.unknowns = mechanism_.unknowns.size();
    for (std::size_t i = 0; i < problem_.unknowns; ++i) {
      (i < mechanism_.accelerations ? problem_.accelerations : problem_.forces).push_back(forms_.unit(i));
    }
  }

  void add_contact(std::size_t index, const ElementKind& kind) {
    const MechanismContact& contact = mechanism_.contacts[index];
    const CompiledContact& compiled = compiled_.contacts[index];
    auto& element = add_element(kind);
    element.gap = forms_.form(compiled.gap, contact.gap_name);
    problem_.accelerations.push_back(element.gap);
    element.normal = forms_.unit(contact.normal);
    if (contact.slip) {
      const auto slip = forms_.form(compiled.slip, contact.slip_name);
      problem_.accelerations.push_back(slip);
      if (!contact.frictionless()) element.slip = slip;
    }
    if (contact.second) {
      const auto slip = forms_.form(compiled.second, contact.second->name);
      problem_.accelerations.push_back(slip);
      element.second_slip = slip;
    }
    if (contact.frictionless()) return;
    const std::string what = "the friction of " + contact.name;
    element.tangent = forms_.unit(*contact.tangent);
    element.static_limit = forms_.limit(*compiled.static_friction, contact.normal, what);
    element.kinetic_limit = forms_.limit(*compiled.kinetic_friction, contact.normal, what);
    if (contact.second) element.second_tangent = forms_.unit(contact.second->force);
    if (compiled.drag.size() != 2) return;
    element.drag = forms_.limit(compiled.drag[0], contact.normal, what);
    element.second_drag = forms_.limit(compiled.drag[1], contact.normal, what);
  }

  void add_friction(std::size_t index, const ElementKind& kind) {
    const MechanismFriction& friction = mechanism_.friction[index];
    const CompiledFriction& compiled = compiled_.friction[index];
    auto& element = add_element(kind);
    element.slip = forms_.form(compiled.slip, friction.slip_name);
    problem_.accelerations.push_back(element.slip);
    element.tangent = forms_.unit(friction.force);
    element.static_limit = forms_.form(compiled.static_limit, "the limit of " + friction.name);
    element.kinetic_limit = forms_.form(compiled.kinetic_limit, "the limit of " + friction.name);
  }

 private:
  auto& add_element(const ElementKind& kind) {
    problem_.elements.emplace_back();
    problem_.elements.back().kind = kind;
    return problem_.elements.back();
  }

  const Mechanism& mechanism_;
  const CompiledMechanism& compiled_;
  Forms& forms_;
  Problem& problem_;
};

template <class Forms, class Problem>
void assemble(const Mechanism& mechanism, const CompiledMechanism& compiled, const std::vector<ElementKind>& kinds,
              Forms& forms, Problem& problem) {
  Assembly<Forms, Problem> assembly(mechanism, compiled, forms, problem);
  assembly.add_equations();
  assembly.add_unknowns();
  const std::size_t contacts = mechanism.contacts.size();
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (i < contacts) {
      assembly.add_contact(i, kinds[i]);
    } else {
      assembly.add_friction(i - contacts, kinds[i]);
    }
  }
}

}  // namespace slipproof
