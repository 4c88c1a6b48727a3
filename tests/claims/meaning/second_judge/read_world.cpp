// The numbers of a world from the expressions of its setting.
#include <algorithm>

#include "claims/meaning/second_judge/world.hpp"
#include "support/bicycle/linear_form.hpp"

namespace slipproof::meaning {

bool World::read_point() {
  for (const Parameter& parameter : setting_.parameters) {
    if (!is_true(truth_of(parameter.domain, names_))) return false;
  }
  if (setting_.angle && !is_true(truth_of(setting_.angle, names_))) return false;
  return setting_.mechanics ? read_mechanics() : read_bicycle();
}

/// Of degree 1 at most, as the random settings have it.
bool World::read_load(const Tree& load) {
  const Number at0 = number_of(load, at(0)), at1 = number_of(load, at(1));
  if (!at0 || !at1) return false;
  offset_ = *at0;
  slope_ = *at1 - *at0;
  return slope_ != 0;
}

/// "M > 0, R > 0, h > -R, b2 + b3 > 0, I1, I2, I3 >= 0, r1, r2 > 0, f >= 0, g > 0, and J > 0 where J is given"
bool World::read_bicycle() {
  std::map<std::string, Rational> values;
  for (const auto& [symbol, tree] : setting_.scene) {
    if (symbol == "F") continue;
    const Number value = number_of(tree, names_);
    if (!value) return false;
    values[symbol] = *value;
  }
  const auto of = [&](const char* symbol) { return values.at(symbol); };
  const bool J = values.contains("J");
  Bicycle<Rational> p = {of("M"),  of("R"),  of("h"),  of("b2"), of("b3"), of("I1"),
                         of("I2"), of("I3"), of("r1"), of("r2"), of("L"),  std::nullopt};
  if (J) p.J = of("J");
  const Road<Rational> road{of("f"), of("g")};
  const bool frame = p.M > 0 && p.R > 0 && p.h > -p.R && p.b2 + p.b3 > 0;
  const bool bodies = p.I1 >= 0 && p.I2 >= 0 && p.I3 >= 0 && p.r1 > 0 && p.r2 > 0 && (!p.J || *p.J > 0);
  if (!frame || !bodies || road.f < 0 || road.g <= 0 || !read_load(setting_.scene.at("F"))) return false;
  unknowns_ = {"a", "a_y", "phi", "eps1", "eps2", "eps3", "T", "S2", "S3", "N2", "N3"};
  accelerations_ = {"a", "a_y", "phi", "eps1", "eps2", "eps3"};
  for (const std::string& unknown : unknowns_) name_quantity(unknown, unit(unknown));
  const auto system = raw_system(p, road, setting_.external ? ForceKind::external : ForceKind::internal, ContactMode{});
  for (const auto& form : system) {
    Row row(form.coefficients.begin(), form.coefficients.end());
    row.push_back(form.constant + row.back() * offset_);
    row[force_column()] *= slope_;
    equations_.push_back(std::move(row));
  }
  for (const char* wheel : {"2", "3"}) {  // rolling: gap and slip of each
    Element& element = elements_.emplace_back();
    const std::size_t first = *wheel == '2' ? 7 : 9;
    element.gap = equations_[first];
    element.slip = equations_[first + 1];
    element.normal = unit(std::string("N") + wheel);
    element.tangent = unit(std::string("S") + wheel);
    element.static_limit = element.kinetic_limit = added(Row(constant_column() + 1), road.f, element.normal);
    using enum ElementState;
    element.states = {stick, slip_forward, slip_backward, lift};
    element.limited = true;
    element.lift_modelled = J;
    for (const auto& [what, row] : {std::pair{"gap", element.gap}, {"slip", element.slip}}) {
      name_quantity(std::string(what) + wheel, row);
      accelerations_.push_back(std::string(what) + wheel);
    }
  }
  equations_.resize(7);
  return true;
}

Row World::unit(const std::string& unknown) const {
  Row row(constant_column() + 1);
  row[static_cast<std::size_t>(std::find(unknowns_.begin(), unknowns_.end(), unknown) - unknowns_.begin())] = 1;
  return row;
}

void World::name_quantity(const std::string& name, const Row& row) {
  quantities_.push_back(name);
  forms_[name] = row;
}

std::optional<Row> World::row(const Sum& sum, const Names& names) const {
  Row result(constant_column() + 1);
  for (const auto& [coefficient, what] : sum) {
    const Number value = number_of(coefficient, names);
    if (!value) return std::nullopt;
    if (what.empty()) {
      result[constant_column()] += *value;
    } else if (what == setting_.mechanics->load) {
      result[force_column()] += *value * slope_;
      result[constant_column()] += *value * offset_;
    } else {
      result = added(std::move(result), *value, unit(what));
    }
  }
  return result;
}

/// "The expressions have values that satisfy the domains of its parameters and angles and all of [assume], every
/// coefficient has a value, and the load is of degree 1 in the force variable."
bool World::read_mechanics() {
  const Mechanics& mechanics = *setting_.mechanics;
  Names names;
  names.definitions = {mechanics.definitions.begin(), mechanics.definitions.end()};
  bool J = true;
  for (const auto& [symbol, tree] : setting_.scene) {
    if (symbol == mechanics.load) continue;
    const Number value = number_of(tree, names_);
    if (!value) return false;
    names.values[symbol] = *value;
  }
  for (const Parameter& parameter : mechanics.parameters) {
    if (!setting_.scene.contains(parameter.symbol)) {
      J = false;
      names.values[parameter.symbol] = 0;
    } else if (!is_true(truth_of(parameter.domain, names))) {
      return false;
    }
  }
  if (mechanics.angle) {
    const Rational c = names.values.at("c"), s = names.values.at("s");
    if (c * c + s * s != 1) return false;
  }
  if (mechanics.assume && !is_true(truth_of(mechanics.assume, names))) return false;
  if (!mechanics.load.empty() && !read_load(setting_.scene.at(mechanics.load))) return false;
  for (const Tree& coefficient : mechanics.coefficients()) {
    if (!number_of(coefficient, names)) return false;
  }
  unknowns_ = mechanics.unknowns();
  accelerations_ = mechanics.accelerations;
  for (const std::string& unknown : unknowns_) name_quantity(unknown, unit(unknown));
  for (std::size_t i = 0; i < mechanics.equations.size(); ++i) {
    Row equation = added(*row(mechanics.equations[i].left, names), -1, *row(mechanics.equations[i].right, names));
    equations_.push_back(added(std::move(equation), -1, *row(mechanics.contact_forces(i), names)));
  }
  for (const Mechanics::Link& link : mechanics.links) equations_.push_back(*row(link.zero, names));
  for (const Mechanics::Element& given : mechanics.elements) {
    Element element;
    element.contact = given.is_contact();
    element.limited = !given.is_contact() || given.static_friction;
    element.slides =
        given.start == ElementKind::Start::slides_forward || given.start == ElementKind::Start::slides_backward;
    element.starts_open = given.start == ElementKind::Start::open;
    element.lift_modelled = J || !given.lift_needs_J;
    element.states = states_of(given);
    element.gap = *row(given.gap, names);
    element.slip = *row(given.slip, names);
    if (given.is_contact()) element.normal = unit(given.normal());
    if (element.limited) element.tangent = unit(given.tangent());
    if (given.static_friction) {
      const Row none(constant_column() + 1);
      element.static_limit = added(none, *number_of(given.static_friction, names), element.normal);
      element.kinetic_limit = added(none, *number_of(given.kinetic_friction, names), element.normal);
    } else {
      element.static_limit = *row(given.static_limit, names);
      element.kinetic_limit = *row(given.kinetic_limit, names);
    }
    const auto add = [&](const std::string& name, const Row& form) {
      name_quantity(name, form);
      accelerations_.push_back(name);
    };
    if (!given.gap.empty()) add("gap_" + given.name, element.gap);
    if (!given.slip.empty()) add("slip_" + given.name, element.slip);
    elements_.push_back(std::move(element));
  }
  return true;
}

}  // namespace slipproof::meaning
