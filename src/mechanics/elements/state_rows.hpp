// The equations and conditions of each state of each element, in the form that a solver uses.
#pragma once

#include <cstddef>
#include <vector>

#include "mechanics/elements/friction_problem.hpp"

namespace slipproof {

/// For each element, the states to consider.
using StatesOfElements = std::vector<std::vector<ElementState>>;

/// The rows of each element and state: calls equation(rows, form) for each equation of the state, and condition(rows,
/// form, which) for each condition. Rows of other states stay empty.
template <class StateRows, class AddEquation, class AddCondition>
std::vector<std::vector<StateRows>> rows_by_state(const FrictionProblem& problem, const StatesOfElements& states,
                                                  const AddEquation& equation, const AddCondition& condition) {
  std::vector<std::vector<StateRows>> result;
  for (std::size_t i = 0; i < problem.elements.size(); ++i) {
    const ProblemElement& element = problem.elements[i];
    std::vector<StateRows>& of_element = result.emplace_back();
    for (const ElementState state : states[i]) {
      const auto number = static_cast<std::size_t>(state);
      if (of_element.size() <= number) of_element.resize(number + 1);
      StateRows& rows = of_element[number];
      for (const StateEquation e : equations(element.kind, state)) equation(rows, form_of(element, state, e));
      for (const StateCondition c : conditions(element.kind, state)) condition(rows, form_of(element, state, c), c);
    }
  }
  return result;
}

}  // namespace slipproof
