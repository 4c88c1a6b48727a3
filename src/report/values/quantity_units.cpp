#include "report/values/quantity_units.hpp"

#include <algorithm>

namespace slipproof {

namespace {

/// The unit of a form in accelerations, by a term whose coefficient is 1 or -1.
std::string unit_of(const Mechanism& mechanism, const SymbolicForm& form) {
  for (const auto& [unknown, coefficient] : form.terms) {
    const bool negated = coefficient->operation == Operation::negate;
    const Expression& size = negated ? coefficient->operands[0] : coefficient;
    if (size->operation == Operation::number && abs(size->number) == 1) return mechanism.unknowns[unknown].unit;
  }
  return {};
}

bool is_in_kilograms(const Mechanism& mechanism) {
  return std::ranges::any_of(mechanism.parameters, [](const auto& parameter) { return parameter.unit == "kg"; });
}

}  // namespace

std::vector<std::string> acceleration_units(const Mechanism& mechanism) {
  std::vector<std::string> units;
  for (std::size_t i = 0; i < mechanism.accelerations; ++i) units.push_back(mechanism.unknowns[i].unit);
  const bool any = std::ranges::any_of(units, [](const std::string& unit) { return !unit.empty(); });
  const auto along = [&](const SymbolicForm& form) {
    return mechanism.bodies && any ? std::string(mechanism.impact ? "m/s" : "m/s^2") : unit_of(mechanism, form);
  };
  for (const MechanismContact& contact : mechanism.contacts) {
    units.push_back(along(contact.gap_form));
    if (contact.slip) units.push_back(along(contact.slip_form));
    if (contact.second) units.push_back(along(contact.second->form));
  }
  for (const MechanismFriction& friction : mechanism.friction) units.push_back(unit_of(mechanism, friction.slip_form));
  return units;
}

std::vector<std::string> force_units(const Mechanism& mechanism) {
  using Role = MechanismUnknown::Role;
  const bool newtons = mechanism.bodies && is_in_kilograms(mechanism);
  std::vector<std::string> units;
  for (std::size_t i = mechanism.accelerations; i < mechanism.unknowns.size(); ++i) {
    const MechanismUnknown& force = mechanism.unknowns[i];
    const bool of_contact = force.role == Role::normal || force.role == Role::tangent;
    units.push_back(force.unit.empty() && of_contact && newtons ? (mechanism.impact ? "N s" : "N") : force.unit);
  }
  return units;
}

std::string unit_suffix(const std::string& unit) {
  return unit.empty() || unit == "1" ? "" : " " + unit;
}

}  // namespace slipproof
