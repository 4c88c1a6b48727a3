#include "mechanics/mechanism/compiled.hpp"

namespace slipproof {

CompiledMechanism::CompiledMechanism(const Mechanism& mechanism)
    : parameters_(mechanism.parameters.size()),
      angles_(mechanism.angles.size()),
      unknowns_(mechanism.unknowns.size()),
      names_(mechanism) {
  for (const MechanismParameter& parameter : mechanism.parameters) scope_.slots.push_back({parameter.symbol, {}});
  for (const MechanismAngle& angle : mechanism.angles) {
    scope_.slots.push_back({angle.cosine, {}});
    scope_.slots.push_back({angle.sine, {}});
  }
  for (const MechanismDefinition& definition : mechanism.definitions) scope_.slots.push_back({definition.symbol, {}});
  scope_.slots.push_back({mechanism.load ? mechanism.load->symbol : "", {}});
  for (std::size_t i = 0; i < mechanism.definitions.size(); ++i) {
    scope_.slots[definition(i)].definition = compile(mechanism.definitions[i].expression.expression);
  }
  for (const MechanismEquation& equation : mechanism.equations) equations.push_back(compile(equation.form));
  for (const MechanismLink& link : mechanism.links) equations.push_back(compile(link.form));
  for (const MechanismContact& contact : mechanism.contacts) {
    CompiledContact compiled{compile(contact.gap_form), compile(contact.slip_form), {}, {}, {}, {}, {}};
    if (contact.second) compiled.second = compile(contact.second->form);
    for (const PlacedExpression& along : contact.sliding) compiled.sliding.push_back(compile(along.expression));
    if (!contact.frictionless()) {
      compiled.static_friction = compile(contact.static_friction.expression);
      compiled.kinetic_friction = compile(contact.kinetic_friction.expression);
      for (const PlacedExpression& along : contact.sliding)
        compiled.drag.push_back(compile(drag_factor(contact, along)));
    }
    contacts.push_back(std::move(compiled));
  }
  for (const MechanismFriction& one : mechanism.friction) {
    friction.push_back({compile(one.slip_form), compile(one.static_form), compile(one.kinetic_form)});
  }
  for (const MechanismParameter& one : mechanism.parameters) {
    parameter_domains.push_back(compile(one.domain.expression));
  }
  for (const MechanismAngle& one : mechanism.angles) angle_domains.push_back(compile(one.domain.expression));
  for (const MechanismCondition& one : mechanism.assume) assume.push_back(compile(one.condition.expression));
  for (const MechanismCondition& one : mechanism.realisable) realisable.push_back(compile(one.condition.expression));
  Mistakes none(mechanism.file);  // the reader has reported them
  for (const LoadBound& bound : load_bounds(mechanism, none)) {
    // A bound has no unknowns in it, and its load comes first.
    load_domain.push_back({compile(SymbolicForm{{}, bound.load, bound.constant}, 0), bound.relation});
  }
}

Program CompiledMechanism::compile(const Expression& expression) const {
  return {expression, [&](std::string_view symbol) -> std::optional<std::size_t> {
            const auto entry = names_.find(symbol);
            if (!entry) return std::nullopt;
            switch (entry->kind) {
              case NameKind::parameter:
                return parameter(entry->index);
              case NameKind::angle:
                return parameters_ + entry->index;
              case NameKind::definition:
                return definition(entry->index);
              case NameKind::load:
                return load();
              default:
                return std::nullopt;
            }
          }};
}

CompiledForm CompiledMechanism::compile(const SymbolicForm& form) const {
  return compile(form, unknowns_);
}

CompiledForm CompiledMechanism::compile(const SymbolicForm& form, std::size_t load) const {
  CompiledForm compiled;
  for (const auto& [unknown, coefficient] : form.terms) compiled.terms.emplace_back(unknown, compile(coefficient));
  if (!is_literal_zero(form.load)) compiled.terms.emplace_back(load, compile(form.load));
  if (!is_literal_zero(form.constant)) compiled.constant = compile(form.constant);
  return compiled;
}

}  // namespace slipproof
