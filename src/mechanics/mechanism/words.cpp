#include "mechanics/mechanism/words.hpp"

#include <algorithm>

#include "mechanics/mechanism/names.hpp"

namespace slipproof {

namespace {

/// `c * N`; of a contact that is pulled the opposite.
std::string own_limit(const Expression& limit, bool pulled) {
  return pulled ? to_string(make(Operation::negate, {limit})) : to_string(limit);
}

/// `mu N2`: a coefficient before a force, as people write it.
std::string friction_limit(const Expression& coefficient, const std::string& normal, bool pulled) {
  const std::string sign = pulled ? "-" : "";
  if (coefficient->operation == Operation::number && coefficient->number == 1) return sign + normal;
  const bool loose = binding(coefficient->operation) < Binding::unary;
  const std::string text = to_string(coefficient);
  return sign + (loose ? "(" + text + ")" : text) + " " + normal;  // -mu N1: a pull is a negative N1
}

}  // namespace

std::string condition_name(const Mechanism& mechanism, std::size_t element, ElementState state,
                           StateCondition condition, bool strict) {
  const std::string at_least = strict ? " > 0" : " >= 0", at_most = strict ? " < 0" : " <= 0";
  const bool is_contact = element < mechanism.contacts.size();
  const MechanismContact* contact = is_contact ? &mechanism.contacts[element] : nullptr;
  const MechanismFriction* friction = is_contact ? nullptr : &mechanism.friction[element - mechanism.contacts.size()];
  const auto force = [&](std::size_t unknown) { return mechanism.unknowns[unknown].symbol; };
  switch (condition) {
    case StateCondition::pushes:
      return force(contact->normal) + at_least;
    case StateCondition::pulls:
      return force(contact->normal) + at_most;
    case StateCondition::holds_forward:
    case StateCondition::holds_backward: {
      const std::string tangent = force(is_contact ? *contact->tangent : friction->force);
      return "|" + tangent + "|" + (strict ? " < " : " <= ") +
             (is_contact ? friction_limit(contact->static_friction.expression, force(contact->normal), is_pulled(state))
                         : own_limit(friction->static_limit.expression, is_pulled(state)));
    }
    case StateCondition::slips_forward:
      return (is_contact ? contact->slip_name : friction->slip_name) + at_least;
    case StateCondition::slips_backward:
      return (is_contact ? contact->slip_name : friction->slip_name) + at_most;
    case StateCondition::opens:
      return contact->gap_name + at_least;
    case StateCondition::static_limit:
      return own_limit(friction->static_limit.expression, is_pulled(state)) + at_least;
    case StateCondition::kinetic_limit:
      break;
  }
  return own_limit(friction->kinetic_limit.expression, is_pulled(state)) + at_least;
}

std::optional<ModePattern> parse_mode(const Mechanism& mechanism, const std::vector<ElementKind>& kinds,
                                      const PlacedText& text, std::string_view key, Mistakes& mistakes) {
  const std::string prefix = std::string(key) + ": ";
  const std::string_view whole = text.text();
  const auto count = static_cast<std::size_t>(std::count(whole.begin(), whole.end(), '/')) + 1;
  if (count != kinds.size()) {
    mistakes.add(text.at(0), prefix + "found " + in_quotes(whole) + ", expected " + std::to_string(kinds.size()) +
                                 (kinds.size() == 1 ? " state" : " states joined by /"));
    return std::nullopt;
  }
  ModePattern pattern;
  std::vector<ElementKind> lifting = kinds;
  for (ElementKind& kind : lifting) kind.lifts = kind.slips = true;
  std::size_t start = 0;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const std::size_t end = std::min(whole.find('/', start), whole.size());
    const std::string_view part = whole.substr(start, end - start);
    std::vector<std::string_view> known{"*"};
    std::optional<ElementState> found;
    for (const ElementState state : states(lifting[i])) {
      known.push_back(name(state));
      if (known.back() == part) found = state;
    }
    if (!found && part != "*") {
      mistakes.add(text.at(start), prefix + unknown_name("state of " + element_name(mechanism, i), part, known));
      return std::nullopt;
    }
    pattern.states.push_back(found);
    start = end + 1;
  }
  if (modes_of(pattern, lifting).empty()) {
    mistakes.add(text.at(0), prefix + "found " + in_quotes(whole) +
                                 ", in which a contact and the friction element at it do not go together: expected "
                                 "\"free\" where the contact lifts, and nowhere else");
    return std::nullopt;
  }
  return pattern;
}

std::vector<MechanismMode> modes_of(const ModePattern& pattern, const std::vector<ElementKind>& kinds) {
  std::vector<std::vector<ElementState>> choices;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    choices.push_back(states(kinds[i]));
    const auto wanted = pattern.states[i];
    std::erase_if(choices.back(), [&](ElementState state) { return wanted && *wanted != state; });
  }
  return modes_of(kinds, choices);
}

}  // namespace slipproof
