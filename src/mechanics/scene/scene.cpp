#include "mechanics/scene/scene.hpp"

#include <algorithm>
#include <stdexcept>

#include "base/number/format.hpp"
#include "mechanics/mechanism/forms.hpp"
#include "mechanics/mechanism/names.hpp"
#include "mechanics/points/degrees.hpp"

namespace slipproof {

MechanismScene with_load(const MechanismScene& scene, std::string_view parameter) {
  const Mechanism& before = scene.mechanism;
  if (before.load && before.load->symbol == parameter) return scene;
  MechanismScene changed = scene;
  changed.mechanism = with_load(before, parameter);
  changed.combined.clear();
  if (before.load && !scene.load) {
    throw std::invalid_argument("the scene has no value of " + before.load->symbol +
                                ", expected one: it is a parameter where " + std::string(parameter) + " is the load");
  }
  const auto found = std::find_if(before.parameters.begin(), before.parameters.end(),
                                  [&](const MechanismParameter& p) { return p.symbol == parameter; });
  const auto index = found - before.parameters.begin();
  const auto i = static_cast<std::size_t>(index);
  changed.load = scene.values.given[i] ? std::optional(scene.values.parameters[i]) : std::nullopt;
  changed.values.parameters.erase(changed.values.parameters.begin() + index);
  changed.values.given.erase(changed.values.given.begin() + index);
  if (before.load) {
    changed.values.parameters.push_back(*scene.load);
    changed.values.given.push_back(true);
  }
  return changed;
}

bool set_value(MechanismScene& scene, std::string_view name, const Rational& value) {
  const Mechanism& m = scene.mechanism;
  for (std::size_t i = 0; i < m.parameters.size(); ++i) {
    if (m.parameters[i].symbol != name) continue;
    scene.values.parameters[i] = value;
    scene.values.given[i] = true;
    return true;
  }
  for (std::size_t i = 0; i < m.angles.size(); ++i) {
    if (m.angles[i].name != name) continue;
    scene.values.angles[i] = point_of_tan_half(value);
    return true;
  }
  if (!m.load || m.load->symbol != name) return false;
  scene.load = value;
  return true;
}

MechanismScene with_values(const MechanismScene& scene, const std::vector<std::pair<std::string, Rational>>& values) {
  MechanismScene changed = scene;
  for (const auto& [name, value] : values) {
    if (set_value(changed, name, value)) continue;
    throw std::invalid_argument(unknown_name("parameter", name, value_names(changed.mechanism)));
  }
  const ProblemMaker maker(changed.mechanism);
  const auto broken = maker.broken(changed.values);
  if (!broken.empty()) {
    throw std::invalid_argument("found values outside the domain, expected " +
                                to_string(broken.front().condition->expression));
  }
  if (changed.load && !maker.load_domain(changed.values).contains(*changed.load)) {
    throw std::invalid_argument("found " + changed.mechanism.load->symbol + " = " + exact_text(*changed.load) +
                                ", expected a value in " + to_string(maker.load_domain(changed.values)));
  }
  return changed;
}

std::string usual_parameter(const MechanismScene& scene) {
  const auto given = [&](std::string_view symbol) {
    const auto& all = scene.mechanism.parameters;
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.symbol == symbol; });
    return found != all.end() && scene.values.given[static_cast<std::size_t>(found - all.begin())];
  };
  for (const MechanismContact& contact : scene.mechanism.contacts) {
    if (contact.frictionless()) continue;
    const Expression& friction = contact.static_friction.expression;
    if (friction->operation == Operation::symbol && given(friction->symbol)) return friction->symbol;
  }
  for (const MechanismParameter& parameter : scene.mechanism.parameters) {
    if (given(parameter.symbol)) return parameter.symbol;
  }
  return scene.mechanism.angles.empty() ? std::string() : scene.mechanism.angles.front().name;
}

}  // namespace slipproof
