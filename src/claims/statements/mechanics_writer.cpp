#include "claims/statements/mechanics_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "claims/plain/determined_forces.hpp"
#include "claims/statements/formulas.hpp"

namespace slipproof {

namespace {

constexpr auto let = Directive::Kind::let, define = Directive::Kind::define;

Relation mirrored(Relation relation) {
  switch (relation) {
    case Relation::less:
      return Relation::greater;
    case Relation::less_equal:
      return Relation::greater_equal;
    case Relation::greater:
      return Relation::less;
    case Relation::greater_equal:
      return Relation::less_equal;
    default:
      return relation;
  }
}

std::vector<std::string> unknowns_of(const Mechanism& mechanism) {
  std::vector<std::string> result;
  for (const MechanismUnknown& unknown : mechanism.unknowns) result.push_back(unknown.symbol);
  return result;
}

bool is_of_accelerations(StateEquation e) {
  return e == StateEquation::gap || e == StateEquation::slip || e == StateEquation::second_slip;
}
bool is_of_accelerations(StateCondition c) {
  return c == StateCondition::slips_forward || c == StateCondition::slips_backward || c == StateCondition::opens;
}

/// Brackets are printed around all of a side only; here they are in a power.
Expression without_brackets(const Expression& e) {
  if (e->operands.size() == 1 && (e->operation == Operation::add || e->operation == Operation::multiply))
    return without_brackets(e->operands[0]);
  if (e->operation != Operation::multiply) return e;
  return make(Operation::multiply, {without_brackets(e->operands[0]), without_brackets(e->operands[1])});
}

}  // namespace

Expression WrittenForm::compared(Relation relation) const {
  return make_comparison({alone(), bound()}, {negative_ ? mirrored(relation) : relation});
}

Expression WrittenForm::bound() const {
  if (!unknown_ || !limit_) return make_number(0);
  return limit_negative_ == negative_ ? make(Operation::negate, {limit_}) : limit_;
}

MechanicsWriter::MechanicsWriter(const Setting& setting, const SettingNames& names, const PlainSigns& signs)
    : setting_(setting),
      signs_(signs),
      kinds_(setting.kinds()),
      unknowns_(unknowns_of(*setting.mechanism)),
      made_up_(names, unknowns_) {
  name_symbols();
  write_elements();
}

void MechanicsWriter::name_symbols() {
  const auto add = [&](const std::string& symbol) {
    const auto value = setting_.scene.find(symbol);
    const bool own = value != setting_.scene.end() && is_symbol(value->second, symbol);
    names_.emplace(symbol, own ? symbol : made_up_.take(symbol));
  };
  const Mechanism& mechanism = *setting_.mechanism;
  for (const MechanismParameter& parameter : mechanism.parameters) add(parameter.symbol);
  for (const MechanismAngle& angle : mechanism.angles) {
    add(angle.cosine);
    add(angle.sine);
  }
  if (mechanism.load) add(mechanism.load->symbol);
  for (const MechanismDefinition& definition : mechanism.definitions) add(definition.symbol);
  const auto name_equation = [&](const std::string& name) { equation_names_.push_back(made_up_.take(name)); };
  for (const MechanismEquation& equation : mechanism.equations) name_equation(equation.name);
  for (const MechanismLink& link : mechanism.links) name_equation(link.name);
}

Expression MechanicsWriter::number(const Expression& of_mechanism) const {
  const Expression renamed = substitute(of_mechanism, [&](const std::string& symbol) {
    const auto found = names_.find(symbol);
    return found == names_.end() ? nullptr : make_symbol(found->second);
  });
  const bool defined = signs_.defined(setting_.in_family(of_mechanism));
  const Expression result = written_number(renamed, [&](const Expression& e) { return defined || has_no_division(e); });
  complete_ = complete_ && result;
  return result ? result : make_number(0);
}

Expression MechanicsWriter::friction(const Expression& coefficient, const std::string& normal) const {
  const Expression factor = number(coefficient);
  return tight_product(coefficient->operation == Operation::symbol ? factor : bracketed(factor), make_symbol(normal));
}

void MechanicsWriter::write_elements() {
  for (const MechanismContact& contact : setting_.mechanism->contacts) {
    WrittenElement& element = elements_.emplace_back();
    const std::string& normal = unknowns_[contact.normal];
    name_states(element, contact.name);
    element.gap = WrittenForm(contact.gap_name);
    element.normal = WrittenForm(normal);
    if (contact.frictionless()) continue;
    element.slip = WrittenForm(contact.slip_name);
    element.tangent = WrittenForm(unknowns_[*contact.tangent]);
    element.static_limit = WrittenForm::limit(friction(contact.static_friction.expression, normal));
    element.kinetic_limit = WrittenForm::limit(friction(contact.kinetic_friction.expression, normal));
    if (!contact.second) continue;
    element.second_slip = WrittenForm(contact.second->name);
    element.second_tangent = WrittenForm(unknowns_[contact.second->force]);
    if (contact.sliding.size() != 2) continue;
    element.drag = WrittenForm::limit(friction(drag_factor(contact, contact.sliding[0]), normal));
    element.second_drag = WrittenForm::limit(friction(drag_factor(contact, contact.sliding[1]), normal));
  }
  for (const MechanismFriction& friction : setting_.mechanism->friction) {
    WrittenElement& element = elements_.emplace_back();
    name_states(element, friction.name);
    element.slip = WrittenForm(friction.slip_name);
    element.tangent = WrittenForm(unknowns_[friction.force]);
    element.static_limit = WrittenForm::limit(bracketed(number(friction.static_limit.expression)));
    element.kinetic_limit = WrittenForm::limit(bracketed(number(friction.kinetic_limit.expression)));
  }
}

void MechanicsWriter::name_states(WrittenElement& element, const std::string& name) {
  constexpr std::array<const char*, element_state_count> verbs{
      "sticks",        "slips_forwards",        "slips_backwards",        "lifts",   "touches",
      "sticks_pulled", "slips_forwards_pulled", "slips_backwards_pulled", "is_free", "slips"};
  for (std::size_t i = 0; i < verbs.size(); ++i)
    element.state_names[i] = made_up_.take(fmt::format("{}_{}", name, verbs[i]));
}

std::vector<std::string> MechanicsWriter::accelerations() const {
  return {unknowns_.begin(), unknowns_.begin() + static_cast<std::ptrdiff_t>(setting_.mechanism->accelerations)};
}

std::vector<Directive> MechanicsWriter::scene() const {
  std::vector<Directive> result;
  const auto add = [&](const std::string& symbol) {
    const auto value = setting_.scene.find(symbol);
    Expression number = make_number(0);
    if (value != setting_.scene.end()) {
      if (is_symbol(value->second, symbol)) return;
      const Expression given = written_number(value->second, [&](const Expression& e) { return signs_.defined(e); });
      complete_ = complete_ && given;
      if (given) number = given;
    }
    result.push_back({let, 0, {name(symbol)}, number});
  };
  const Mechanism& mechanism = *setting_.mechanism;
  for (const MechanismParameter& parameter : mechanism.parameters) add(parameter.symbol);
  for (const MechanismAngle& angle : mechanism.angles) {
    add(angle.cosine);
    add(angle.sine);
  }
  if (mechanism.load) add(mechanism.load->symbol);
  for (const MechanismDefinition& definition : mechanism.definitions)
    result.push_back({let, 0, {name(definition.symbol)}, number(definition.expression.expression)});
  return result;
}

std::vector<Directive> MechanicsWriter::equations() const {
  const Mechanism& mechanism = *setting_.mechanism;
  std::vector<Directive> result;
  const auto add_value = [&](const std::string& name, const PlacedExpression& value) {
    result.push_back({let, 0, {name}, number(value.expression)});
  };
  for (const MechanismContact& contact : mechanism.contacts) {
    add_value(contact.gap_name, contact.gap);
    if (contact.slip) add_value(contact.slip_name, contact.slip);
    if (contact.second) add_value(contact.second->name, contact.second->slip);
  }
  for (const MechanismFriction& friction : mechanism.friction) add_value(friction.slip_name, friction.slip);
  auto name = equation_names_.begin();
  const auto add_equation = [&](const Expression& left, const Expression& right) {
    result.push_back({define, 0, {*name++}, make_comparison({left, right}, {Relation::equal})});
  };
  for (const MechanismEquation& equation : mechanism.equations)
    add_equation(number(equation.left.expression), number(equation.whole_right()));
  for (const MechanismLink& link : mechanism.links) add_equation(number(link.zero.expression), make_number(0));
  return result;
}

Expression MechanicsWriter::dynamics() const {
  std::vector<Expression> parts;
  for (const std::string& name : equation_names_) parts.push_back(make_symbol(name));
  return conjoined(parts);
}

Expression MechanicsWriter::on_contacts() const {
  std::vector<Expression> parts;
  for (std::size_t i = 0; i < setting_.mechanism->contacts.size(); ++i) {
    if (kinds_[i].start != ElementKind::Start::open) parts.push_back(elements_[i].gap.compared(Relation::equal));
  }
  return conjoined(parts);
}

bool MechanicsWriter::may_leave_forces_open() const {
  if (!forces_open_) forces_open_ = !plainly_determine_forces(setting_, signs_);
  return *forces_open_;
}

bool MechanicsWriter::is_modelled(const MechanismMode& mode) const {
  return has_mode(kinds_, mode);
}

std::vector<MechanismMode> MechanicsWriter::modes() const {
  return modes_of(kinds_);
}

std::vector<Expression> MechanicsWriter::equations_of(std::size_t element, ElementState state, Relation relation,
                                                      bool of_accelerations) const {
  std::vector<Expression> result;
  for (const StateEquation e : slipproof::equations(kinds_[element], state)) {
    if (!of_accelerations || is_of_accelerations(e))
      result.push_back(form_of(elements_[element], state, e).compared(relation));
  }
  return result;
}

std::vector<StateCondition> MechanicsWriter::conditions_of(std::size_t element, ElementState state) const {
  const WrittenElement& e = elements_[element];
  std::vector<StateCondition> result;
  for (const StateCondition c : conditions(kinds_[element], state)) {
    const bool said = c == StateCondition::holds_backward ||
                      (c == StateCondition::kinetic_limit && same(e.kinetic_limit.alone(), e.static_limit.alone()));
    if (!said) result.push_back(c);
  }
  return result;
}

Expression MechanicsWriter::state_name(std::size_t element, ElementState state) const {
  return make_symbol(elements_[element].state_names[static_cast<std::size_t>(state)]);
}

Expression MechanicsWriter::cone(std::size_t element, Relation relation) const {
  const WrittenElement& e = elements_[element];
  const auto square = [](const WrittenForm& form) { return make_power(without_brackets(form.alone()), 2); };
  const Expression force = make(Operation::add, {square(e.tangent), square(e.second_tangent)});
  return make_comparison({force, square(e.static_limit)}, {relation});
}

Directive MechanicsWriter::state_definition(std::size_t element, ElementState state, bool strict) const {
  const WrittenElement& e = elements_[element];
  const Relation above = strict ? Relation::greater : Relation::greater_equal;
  std::vector<Expression> parts = equations_of(element, state, Relation::equal);
  for (const StateCondition c : conditions_of(element, state)) {
    const Expression condition = form_of(e, state, c).compared(above);
    if (c != StateCondition::holds_forward) {
      parts.push_back(condition);
      continue;
    }
    const Expression least = form_of(e, state, StateCondition::holds_backward).bound();
    parts.push_back(make_comparison({least, condition->operands[0], condition->operands[1]},
                                    {condition->relations[0], condition->relations[0]}));
  }
  if (holds_in_cone(kinds_[element], state))
    parts.push_back(cone(element, strict ? Relation::less : Relation::less_equal));
  return {define, 0, {state_name(element, state)->symbol}, conjoined(parts)};
}

std::vector<Directive> MechanicsWriter::definitions(const MechanismMode& mode, bool strict) const {
  std::vector<Directive> result = equations();
  for (std::size_t i = 0; i < mode.size(); ++i) result.push_back(state_definition(i, mode[i], strict));
  return result;
}

std::vector<Directive> MechanicsWriter::all_definitions(bool strict) const {
  std::vector<Directive> result = equations();
  for (std::size_t i = 0; i < elements(); ++i) {
    for (const ElementState state : states_of(i)) result.push_back(state_definition(i, state, strict));
  }
  return result;
}

Expression MechanicsWriter::in_mode(const MechanismMode& mode) const {
  std::vector<Expression> names;
  for (std::size_t i = 0; i < mode.size(); ++i) names.push_back(state_name(i, mode[i]));
  return conjoined(names);
}

Expression MechanicsWriter::in_any_mode() const {
  std::vector<Expression> all;
  for (std::size_t i = 0; i < elements(); ++i) {
    std::vector<Expression> names;
    for (const ElementState state : states_of(i)) names.push_back(state_name(i, state));
    all.push_back(disjoined(names));
  }
  return conjoined(all);
}

Expression MechanicsWriter::mode_missed(const MechanismMode& mode) const {
  const bool any_forces = may_leave_forces_open();
  std::vector<Expression> parts;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    std::vector<Expression> equations = equations_of(i, mode[i], Relation::not_equal, any_forces);
    parts.insert(parts.end(), equations.begin(), equations.end());
    const auto add = [&](StateCondition c) {
      parts.push_back(form_of(elements_[i], mode[i], c).compared(Relation::less));
    };
    for (const StateCondition c : conditions_of(i, mode[i])) {
      if (any_forces && !is_of_accelerations(c)) continue;
      if (c == StateCondition::holds_forward) add(StateCondition::holds_backward);
      add(c);
    }
    if (!any_forces && holds_in_cone(kinds_[i], mode[i])) parts.push_back(cone(i, Relation::greater));
  }
  return parts.empty() ? make_truth(false) : disjoined(parts);
}

Expression MechanicsWriter::state_equations(const MechanismMode& mode) const {
  std::vector<Expression> all;
  for (std::size_t i = 0; i < mode.size(); ++i) all.push_back(conjoined(equations_of(i, mode[i], Relation::equal)));
  return conjoined(all);
}

}  // namespace slipproof
