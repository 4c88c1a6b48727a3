#include "mechanics/scene/scene.hpp"

#include <algorithm>
#include <stdexcept>

#include "mechanics/mechanism/forms.hpp"

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
