#include "claims/statements/mechanics_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "claims/statements/determined_forces.hpp"
#include "claims/statements/truth_text.hpp"

namespace slipproof {

namespace {

/// Joins the texts of the items of a list by a word; leaves out empty texts.
template <class Items, class Text>
std::string joined(const Items& items, const char* word, const Text& text) {
  std::string result;
  for (const auto& item : items) {
    const std::string part = text(item);
    if (!part.empty()) result += (result.empty() ? "" : word) + part;
  }
  return result;
}

std::vector<std::string> unknowns_of(const Mechanism& mechanism) {
  std::vector<std::string> result;
  for (const MechanismUnknown& unknown : mechanism.unknowns) result.push_back(unknown.symbol);
  return result;
}

bool is_of_accelerations(StateEquation e) {
  return e == StateEquation::gap || e == StateEquation::slip;
}
bool is_of_accelerations(StateCondition c) {
  return c == StateCondition::slips_forward || c == StateCondition::slips_backward || c == StateCondition::opens;
}

}  // namespace

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

std::string MechanicsWriter::number(const Expression& of_mechanism) const {
  const Expression renamed = substitute(of_mechanism, [&](const std::string& symbol) {
    const auto found = names_.find(symbol);
    return found == names_.end() ? nullptr : make_symbol(found->second);
  });
  const bool defined = signs_.defined(setting_.in_family(of_mechanism));
  const auto text = number_text(renamed, [&](const Expression& e) { return defined || has_no_division(e); });
  complete_ = complete_ && text;
  return text.value_or("0");
}

std::string MechanicsWriter::friction(const Expression& coefficient, const std::string& normal) const {
  const std::string text = number(coefficient);
  return coefficient->operation == Operation::symbol ? text + "*" + normal : "(" + text + ")*" + normal;
}

void MechanicsWriter::write_elements() {
  for (const MechanismContact& contact : setting_.mechanism->contacts) {
    ElementText& text = elements_.emplace_back();
    const std::string& normal = unknowns_[contact.normal];
    name_states(text, contact.name);
    text.gap = TextForm(contact.gap_name);
    text.normal = TextForm(normal);
    if (contact.frictionless()) continue;
    text.slip = TextForm(contact.slip_name);
    text.tangent = TextForm(unknowns_[*contact.tangent]);
    text.static_limit = TextForm::limit(friction(contact.static_friction.expression, normal));
    text.kinetic_limit = TextForm::limit(friction(contact.kinetic_friction.expression, normal));
  }
  for (const MechanismFriction& friction : setting_.mechanism->friction) {
    ElementText& text = elements_.emplace_back();
    name_states(text, friction.name);
    text.slip = TextForm(friction.slip_name);
    text.tangent = TextForm(unknowns_[friction.force]);
    text.static_limit = TextForm::limit("(" + number(friction.static_limit.expression) + ")");
    text.kinetic_limit = TextForm::limit("(" + number(friction.kinetic_limit.expression) + ")");
  }
}

void MechanicsWriter::name_states(ElementText& element, const std::string& name) {
  constexpr std::array<const char*, element_state_count> verbs{
      "sticks",        "slips_forwards",        "slips_backwards",        "lifts",  "touches",
      "sticks_pulled", "slips_forwards_pulled", "slips_backwards_pulled", "is_free"};
  for (std::size_t i = 0; i < verbs.size(); ++i)
    element.state_names[i] = made_up_.take(fmt::format("{}_{}", name, verbs[i]));
}

std::vector<std::string> MechanicsWriter::accelerations() const {
  return {unknowns_.begin(), unknowns_.begin() + static_cast<std::ptrdiff_t>(setting_.mechanism->accelerations)};
}

std::string MechanicsWriter::scene() const {
  std::string result;
  const auto let = [&](const std::string& symbol) {
    const auto value = setting_.scene.find(symbol);
    if (value == setting_.scene.end()) {
      result += fmt::format("let {} = 0\n", names_.find(symbol)->second);
    } else if (!is_symbol(value->second, symbol)) {
      const auto text = number_text(value->second, [&](const Expression& e) { return signs_.defined(e); });
      complete_ = complete_ && text;
      result += fmt::format("let {} = {}\n", names_.find(symbol)->second, text.value_or("0"));
    }
  };
  const Mechanism& mechanism = *setting_.mechanism;
  for (const MechanismParameter& parameter : mechanism.parameters) let(parameter.symbol);
  for (const MechanismAngle& angle : mechanism.angles) {
    let(angle.cosine);
    let(angle.sine);
  }
  if (mechanism.load) let(mechanism.load->symbol);
  for (const MechanismDefinition& definition : mechanism.definitions) {
    result +=
        fmt::format("let {} = {}\n", names_.find(definition.symbol)->second, number(definition.expression.expression));
  }
  return result;
}

std::string MechanicsWriter::equations() const {
  const Mechanism& mechanism = *setting_.mechanism;
  std::string result;
  for (const MechanismContact& contact : mechanism.contacts) {
    result += fmt::format("let {} = {}\n", contact.gap_name, number(contact.gap.expression));
    if (contact.slip) result += fmt::format("let {} = {}\n", contact.slip_name, number(contact.slip.expression));
  }
  for (const MechanismFriction& friction : mechanism.friction) {
    result += fmt::format("let {} = {}\n", friction.slip_name, number(friction.slip.expression));
  }
  for (std::size_t i = 0; i < mechanism.equations.size(); ++i) {
    const MechanismEquation& equation = mechanism.equations[i];
    result += fmt::format("define {}: {} = {}\n", equation_names_[i], number(equation.left.expression),
                          number(equation.whole_right()));
  }
  for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
    result += fmt::format("define {}: {} = 0\n", equation_names_[mechanism.equations.size() + i],
                          number(mechanism.links[i].zero.expression));
  }
  return result;
}

std::string MechanicsWriter::dynamics() const {
  return fmt::format("{}", fmt::join(equation_names_, " and "));
}

std::string MechanicsWriter::on_contacts() const {
  std::string result;
  for (std::size_t i = 0; i < setting_.mechanism->contacts.size(); ++i) {
    if (kinds_[i].start == ElementKind::Start::open) continue;
    result += fmt::format("{}{} = 0", result.empty() ? "" : " and ", elements_[i].gap.text());
  }
  return result;
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

std::string MechanicsWriter::equations_of(std::size_t element, ElementState state, const char* is, const char* word,
                                          bool of_accelerations) const {
  return joined(slipproof::equations(kinds_[element], state), word, [&](StateEquation e) {
    if (of_accelerations && !is_of_accelerations(e)) return std::string();
    return form_of(elements_[element], state, e).compared(is, is);
  });
}

/// An element that sticks has two conditions on its friction: both are written in place of the first. Equal limits give
/// one condition.
template <class Text>
std::string MechanicsWriter::conditions_of(std::size_t element, ElementState state, const char* word,
                                           const Text& text) const {
  const ElementText& e = elements_[element];
  return joined(conditions(kinds_[element], state), word, [&](StateCondition c) {
    const bool said = c == StateCondition::holds_backward ||
                      (c == StateCondition::kinetic_limit && e.kinetic_limit.text() == e.static_limit.text());
    return said ? std::string() : text(c);
  });
}

std::string MechanicsWriter::state_name(std::size_t element, ElementState state) const {
  return elements_[element].state_names[static_cast<std::size_t>(state)];
}

std::string MechanicsWriter::state_definition(std::size_t element, ElementState state, bool strict) const {
  const ElementText& e = elements_[element];
  const char *above = strict ? ">" : ">=", *below = strict ? "<" : "<=";
  const std::string all_conditions = conditions_of(element, state, " and ", [&](StateCondition c) {
    const TextForm form = form_of(e, state, c);
    if (c != StateCondition::holds_forward) return form.compared(above, below);
    return fmt::format("{} {} {}", form_of(e, state, StateCondition::holds_backward).bound(), below,
                       form.compared(above, below));
  });
  return fmt::format("define {}: {}{}{}\n", state_name(element, state), equations_of(element, state, "=", " and "),
                     all_conditions.empty() ? "" : " and ", all_conditions);
}

std::string MechanicsWriter::state_definitions(const MechanismMode& mode, bool strict) const {
  std::string result;
  for (std::size_t i = 0; i < mode.size(); ++i) result += state_definition(i, mode[i], strict);
  return result;
}

std::string MechanicsWriter::all_state_definitions(bool strict) const {
  std::string result;
  for (std::size_t i = 0; i < elements(); ++i) {
    for (const ElementState state : states_of(i)) result += state_definition(i, state, strict);
  }
  return result;
}

std::string MechanicsWriter::mode_text(const MechanismMode& mode) const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < mode.size(); ++i) names.push_back(state_name(i, mode[i]));
  return fmt::format("{}", fmt::join(names, " and "));
}

std::string MechanicsWriter::any_mode_text() const {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < elements(); ++i) {
    std::vector<std::string> names;
    for (const ElementState state : states_of(i)) names.push_back(state_name(i, state));
    all.push_back(names.size() == 1 ? names.front() : fmt::format("{{{}}}", fmt::join(names, " or ")));
  }
  return fmt::format("{}", fmt::join(all, " and "));
}

std::string MechanicsWriter::mode_missed_text(const MechanismMode& mode) const {
  const bool any_forces = may_leave_forces_open();
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    parts.push_back(equations_of(i, mode[i], "!=", " or ", any_forces));
    parts.push_back(conditions_of(i, mode[i], " or ", [&](StateCondition c) {
      if (any_forces && !is_of_accelerations(c)) return std::string();
      const std::string missed = form_of(elements_[i], mode[i], c).compared("<", ">");
      if (c != StateCondition::holds_forward) return missed;
      return form_of(elements_[i], mode[i], StateCondition::holds_backward).compared("<", ">") + " or " + missed;
    }));
  }
  const std::string result = joined(parts, " or ", [](const std::string& part) { return part; });
  return result.empty() ? "false" : result;
}

std::string MechanicsWriter::state_equations(const MechanismMode& mode) const {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < mode.size(); ++i) all.push_back(equations_of(i, mode[i], "=", " and "));
  return fmt::format("{}", fmt::join(all, " and "));
}

}  // namespace slipproof
