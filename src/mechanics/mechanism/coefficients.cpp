#include "mechanics/mechanism/coefficients.hpp"

namespace slipproof {

std::vector<Expression> coefficients(const Mechanism& mechanism) {
  std::vector<Expression> result;
  const auto add = [&](const Expression& number) {
    if (number && !is_literal_zero(number)) result.push_back(number);
  };
  const auto add_form = [&](const SymbolicForm& form) {
    for (const auto& [unknown, coefficient] : form.terms) add(coefficient);
    add(form.load);
    add(form.constant);
  };
  for (const MechanismEquation& equation : mechanism.equations) add_form(equation.form);
  for (const MechanismLink& link : mechanism.links) add_form(link.form);
  for (const MechanismContact& contact : mechanism.contacts) {
    add_form(contact.gap_form);
    add_form(contact.slip_form);
    if (contact.second) add_form(contact.second->form);
    add(contact.static_friction.expression);
    add(contact.kinetic_friction.expression);
    for (const PlacedExpression& along : contact.sliding) add(along.expression);
  }
  for (const MechanismFriction& friction : mechanism.friction) {
    for (const SymbolicForm* form : {&friction.slip_form, &friction.static_form, &friction.kinetic_form})
      add_form(*form);
  }
  return result;
}

}  // namespace slipproof
