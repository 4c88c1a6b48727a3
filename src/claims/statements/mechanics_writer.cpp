#include "claims/statements/mechanics_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "claims/statements/truth_text.hpp"

namespace slipproof {

namespace {

/// Letters, digits and underscores, as names in statements may have.
std::string as_name(std::string_view text) {
  std::string name;
  for (const char c : text) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

/// What the items of a list say, joined by a word; those that say nothing are left out.
template <class Items, class Text>
std::string joined(const Items& items, const char* word, const Text& text) {
  std::string result;
  for (const auto& item : items) {
    const std::string part = text(item);
    if (!part.empty()) result += (result.empty() ? "" : word) + part;
  }
  return result;
}

bool is_of_accelerations(StateEquation e) {
  return e == StateEquation::gap || e == StateEquation::slip;
}
bool is_of_accelerations(StateCondition c) {
  return c == StateCondition::slips_forward || c == StateCondition::slips_backward || c == StateCondition::opens;
}

bool is_symbol(const Expression& e, std::string_view symbol) {
  return e->operation == Operation::symbol && e->symbol == symbol;
}

}  // namespace

MechanicsWriter::MechanicsWriter(const Setting& setting, Defined defined)
    : setting_(setting), defined_(std::move(defined)), kinds_(setting.kinds()) {
  for (const MechanismUnknown& unknown : setting.mechanism->unknowns) unknowns_.push_back(unknown.symbol);
  name_symbols();
  write_elements();
}

void MechanicsWriter::name_symbols() {
  for (const Parameter& parameter : setting_.parameters) {
    if (!parameter.angle) taken_.push_back(parameter.symbol);
  }
  for (const PaperAngle& angle : setting_.angles) taken_.insert(taken_.end(), {angle.cosine, angle.sine});
  if (!setting_.force.symbol.empty()) taken_.push_back(setting_.force.symbol);
  for (const Definition& definition : setting_.definitions) taken_.push_back(definition.symbol);
  for (const std::string& quantity : setting_.quantities()) taken_.push_back(quantity);

  const auto add = [&](const std::string& symbol) {
    const auto value = setting_.scene.find(symbol);
    const bool own = value != setting_.scene.end() && is_symbol(value->second, symbol);
    const std::string name = own ? symbol : fresh(symbol);
    names_.emplace(symbol, name);
    if (!own) taken_.push_back(name);
  };
  const Mechanism& mechanism = *setting_.mechanism;
  for (const MechanismParameter& parameter : mechanism.parameters) add(parameter.symbol);
  for (const MechanismAngle& angle : mechanism.angles) {
    add(angle.cosine);
    add(angle.sine);
  }
  if (mechanism.load) add(mechanism.load->symbol);
  for (const MechanismDefinition& definition : mechanism.definitions) add(definition.symbol);
  const auto name_equation = [&](const std::string& name) {
    equation_names_.push_back(fresh(as_name(name)));
    taken_.push_back(equation_names_.back());
  };
  for (const MechanismEquation& equation : mechanism.equations) name_equation(equation.name);
  for (const MechanismLink& link : mechanism.links) name_equation(link.name);
}

std::string MechanicsWriter::fresh(std::string name) const {
  const bool reserved = name == "and" || name == "or" || name == "false";
  if (reserved) name += '_';
  while (std::find(taken_.begin(), taken_.end(), name) != taken_.end()) name += '_';
  return name;
}

std::string MechanicsWriter::number(const Expression& of_mechanism) const {
  const Expression renamed = substitute(of_mechanism, [&](const std::string& symbol) {
    const auto found = names_.find(symbol);
    return found == names_.end() ? nullptr : make_symbol(found->second);
  });
  const bool defined = defined_(setting_.in_paper(of_mechanism));
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
    text.name = as_name(contact.name);
    text.gap = contact.gap_name;
    text.normal = unknowns_[contact.normal];
    if (contact.frictionless()) continue;
    text.slip = contact.slip_name;
    text.tangent = unknowns_[*contact.tangent];
    text.static_limit = friction(contact.static_friction.expression, text.normal);
    text.kinetic_limit = friction(contact.kinetic_friction.expression, text.normal);
  }
  for (const MechanismFriction& friction : setting_.mechanism->friction) {
    ElementText& text = elements_.emplace_back();
    text.name = as_name(friction.name);
    text.slip = friction.slip_name;
    text.tangent = unknowns_[friction.force];
    text.static_limit = "(" + number(friction.static_limit.expression) + ")";
    text.kinetic_limit = "(" + number(friction.kinetic_limit.expression) + ")";
  }
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
      const auto text = number_text(value->second, [&](const Expression& e) { return defined_(e); });
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
    result += fmt::format("{}{} = 0", result.empty() ? "" : " and ", elements_[i].gap);
  }
  return result;
}

bool MechanicsWriter::may_leave_forces_open() const {
  std::size_t ties = setting_.mechanism->links.size();
  for (const ElementKind& kind : kinds_) ties += kind.law == ElementKind::Law::coulomb ? 2 : 1;
  return ties > setting_.mechanism->accelerations;
}

bool MechanicsWriter::is_modelled(const MechanismMode& mode) const {
  return has_mode(kinds_, mode);
}

std::vector<MechanismMode> MechanicsWriter::modes() const {
  return modes_of(kinds_);
}

std::string MechanicsWriter::equation(std::size_t element, ElementState state, StateEquation equation,
                                      const char* is) const {
  const ElementText& e = elements_[element];
  const bool forward = (equation == StateEquation::resists_forward) != is_pulled(state);
  switch (equation) {
    case StateEquation::gap:
      return fmt::format("{} {} 0", e.gap, is);
    case StateEquation::slip:
      return fmt::format("{} {} 0", e.slip, is);
    case StateEquation::no_normal:
      return fmt::format("{} {} 0", e.normal, is);
    case StateEquation::no_tangent:
      return fmt::format("{} {} 0", e.tangent, is);
    default:
      return fmt::format("{} {} {}{}", e.tangent, is, forward ? "-" : "", e.kinetic_limit);
  }
}

/// Both of those on the friction of an element that sticks stand at the first.
std::string MechanicsWriter::condition(std::size_t element, ElementState state, StateCondition condition,
                                       bool strict) const {
  const ElementText& e = elements_[element];
  const char* above = strict ? ">" : ">=";
  const char* below = strict ? "<" : "<=";
  const bool pulled = is_pulled(state);
  switch (condition) {
    case StateCondition::pushes:
      return fmt::format("{} {} 0", e.normal, above);
    case StateCondition::pulls:
      return fmt::format("{} {} 0", e.normal, below);
    case StateCondition::holds_forward:
      return fmt::format("{3}{0} {1} {2} {1} {4}{0}", e.static_limit, below, e.tangent, pulled ? "" : "-",
                         pulled ? "-" : "");
    case StateCondition::holds_backward:
      return {};
    case StateCondition::slips_forward:
      return fmt::format("{} {} 0", e.slip, above);
    case StateCondition::slips_backward:
      return fmt::format("{} {} 0", e.slip, below);
    case StateCondition::opens:
      return fmt::format("{} {} 0", e.gap, above);
    case StateCondition::static_limit:
      return fmt::format("{} {} 0", e.static_limit, above);
    case StateCondition::kinetic_limit:
      break;
  }
  return e.kinetic_limit == e.static_limit ? std::string() : fmt::format("{} {} 0", e.kinetic_limit, above);
}

/// That it fails.
std::string MechanicsWriter::missed(std::size_t element, ElementState state, StateCondition condition) const {
  const ElementText& e = elements_[element];
  const bool pulled = is_pulled(state);
  switch (condition) {
    case StateCondition::pushes:
      return fmt::format("{} < 0", e.normal);
    case StateCondition::pulls:
      return fmt::format("{} > 0", e.normal);
    case StateCondition::holds_forward:
      return fmt::format("{0} < {2}{1} or {0} > {3}{1}", e.tangent, e.static_limit, pulled ? "" : "-",
                         pulled ? "-" : "");
    case StateCondition::holds_backward:
      return {};
    case StateCondition::slips_forward:
      return fmt::format("{} < 0", e.slip);
    case StateCondition::slips_backward:
      return fmt::format("{} > 0", e.slip);
    case StateCondition::opens:
      return fmt::format("{} < 0", e.gap);
    case StateCondition::static_limit:
      return fmt::format("{} < 0", e.static_limit);
    case StateCondition::kinetic_limit:
      break;
  }
  return e.kinetic_limit == e.static_limit ? std::string() : fmt::format("{} < 0", e.kinetic_limit);
}

std::string MechanicsWriter::state_name(std::size_t element, ElementState state) const {
  const char* verb = "";
  switch (state) {
    case ElementState::stick:
      verb = "sticks";
      break;
    case ElementState::slip_forward:
      verb = "slips_forwards";
      break;
    case ElementState::slip_backward:
      verb = "slips_backwards";
      break;
    case ElementState::lift:
      verb = "lifts";
      break;
    case ElementState::touch:
      verb = "touches";
      break;
    case ElementState::pulled_stick:
      verb = "sticks_pulled";
      break;
    case ElementState::pulled_slip_forward:
      verb = "slips_forwards_pulled";
      break;
    case ElementState::pulled_slip_backward:
      verb = "slips_backwards_pulled";
      break;
  }
  return fresh(fmt::format("{}_{}", elements_[element].name, verb));
}

std::string MechanicsWriter::state_definition(std::size_t element, ElementState state, bool strict) const {
  const auto& kind = kinds_[element];
  const std::string all_equations = joined(slipproof::equations(kind, state), " and ",
                                           [&](StateEquation e) { return equation(element, state, e, "="); });
  const std::string all_conditions =
      joined(conditions(kind, state), " and ", [&](StateCondition c) { return condition(element, state, c, strict); });
  return fmt::format("define {}: {}{}{}\n", state_name(element, state), all_equations,
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
  std::string result;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const auto part = [&](const auto& items, const auto& text) {
      const std::string one = joined(items, " or ", text);
      if (!one.empty()) result += (result.empty() ? "" : " or ") + one;
    };
    part(slipproof::equations(kinds_[i], mode[i]), [&](StateEquation e) {
      return any_forces && !is_of_accelerations(e) ? std::string() : equation(i, mode[i], e, "!=");
    });
    part(conditions(kinds_[i], mode[i]), [&](StateCondition c) {
      return any_forces && !is_of_accelerations(c) ? std::string() : missed(i, mode[i], c);
    });
  }
  return result.empty() ? "false" : result;
}

std::string MechanicsWriter::state_equations(const MechanismMode& mode) const {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    all.push_back(joined(slipproof::equations(kinds_[i], mode[i]), " and ",
                         [&](StateEquation e) { return equation(i, mode[i], e, "="); }));
  }
  return fmt::format("{}", fmt::join(all, " and "));
}

}  // namespace slipproof
