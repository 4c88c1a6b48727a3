#include <algorithm>
#include <set>

#include "mechanics/bodies/bodies.hpp"
#include "mechanics/checks/check_parts.hpp"

namespace slipproof::mechanism_checks {

namespace {

/// The symbols in everything but the domains of parameters and angles.
class UsedSymbols {
 public:
  explicit UsedSymbols(const Mechanism& m) {
    for (const auto* conditions : {&m.assume, &m.realisable}) {
      for (const MechanismCondition& one : *conditions) add(one.condition);
    }
    for (const MechanismDefinition& one : m.definitions) add(one.expression);
    for (const MechanismEquation& one : m.equations) add({one.left, one.right});
    for (const MechanismContact& one : m.contacts) add(one);
    for (const MechanismFriction& one : m.friction) add({one.slip, one.static_limit, one.kinetic_limit});
    for (const MechanismLink& one : m.links) add(one.zero);
    for (const MechanismShape& one : m.shapes) {
      for (const auto& point : one.points) add(point);
      add({one.radius, one.force});
    }
    add(m.energy);
    if (m.bodies) {
      visit_expressions(*m.bodies, [&](const PlacedExpression& one, std::string_view, bool) { add(one); });
    }
    for (const MechanismParameter& one : m.parameters) add_other(one.domain, {one.symbol});
    if (m.load) {
      for (const PlacedExpression& one : m.load->domain) add_other(one, {m.load->symbol});
    }
    for (const MechanismAngle& one : m.angles) add_other(one.domain, {one.cosine, one.sine});
  }

  bool has(const std::string& symbol) const { return used_.count(symbol) != 0; }

 private:
  void add(const MechanismContact& contact) {
    add({contact.gap, contact.slip, contact.static_friction, contact.kinetic_friction});
    if (contact.second) add(contact.second->slip);
    for (const auto* pair : {&contact.at, &contact.direction, &contact.slip_direction}) add(*pair);
  }
  void add(const std::vector<PlacedExpression>& all) {
    for (const PlacedExpression& one : all) add(one);
  }
  void add(const PlacedExpression& placed) { add_other(placed, {}); }
  /// The symbols other than those that it is about.
  void add_other(const PlacedExpression& placed, const std::set<std::string>& own) {
    if (!placed) return;
    for (std::string& symbol : symbols(placed.expression)) {
      if (own.count(symbol) == 0) used_.insert(std::move(symbol));
    }
  }

  std::set<std::string> used_;
};

}  // namespace

std::vector<MechanismFinding> check_names(const Mechanism& mechanism) {
  const UsedSymbols used(mechanism);
  std::vector<MechanismFinding> findings;
  const auto unused = [&](const std::string& what, const std::string& symbol, Place place) {
    findings.push_back(warning(MechanismFinding::Check::names, place, "the " + what + " " + symbol + " is never used"));
  };
  for (std::size_t i = 0; i < mechanism.parameters.size(); ++i) {
    const MechanismParameter& parameter = mechanism.parameters[i];
    const auto needs = [&](const MechanismContact& contact) {
      return std::ranges::find(contact.lift_needs, i) != contact.lift_needs.end();
    };
    if (used.has(parameter.symbol) || std::ranges::any_of(mechanism.contacts, needs)) continue;
    unused("parameter", parameter.symbol, parameter.place);
  }
  for (const MechanismDefinition& definition : mechanism.definitions) {
    if (!used.has(definition.symbol)) unused("definition", definition.symbol, definition.place);
  }
  for (const MechanismAngle& angle : mechanism.angles) {
    if (!used.has(angle.cosine) && !used.has(angle.sine)) unused("angle", angle.name, angle.place);
  }
  if (mechanism.load && !used.has(mechanism.load->symbol)) {
    unused("load", mechanism.load->symbol, mechanism.load->place);
  }
  return findings;
}

}  // namespace slipproof::mechanism_checks
