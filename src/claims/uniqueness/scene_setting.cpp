#include "claims/uniqueness/scene_setting.hpp"

#include <memory>
#include <stdexcept>

#include "base/expression/logic.hpp"

namespace slipproof {

namespace {

std::size_t given_parameter(const MechanismScene& scene, const std::string& symbol) {
  const auto& all = scene.mechanism.parameters;
  std::vector<std::string_view> known;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!scene.values.given[i]) continue;
    if (all[i].symbol == symbol) return i;
    known.push_back(all[i].symbol);
  }
  throw std::invalid_argument(unknown_name("parameter of the scene", symbol, known));
}

}  // namespace

Setting setting_along(const MechanismScene& scene, const std::string& parameter) {
  const std::size_t free = given_parameter(scene, parameter);
  Setting setting;
  setting.id = "scene";
  setting.mechanism = std::make_shared<const Mechanism>(scene.mechanism);
  setting.mechanism_name = scene.mechanism.name;
  setting.starts = scene.values.starts;
  setting.strict = false;
  for (std::size_t i = 0; i < scene.mechanism.parameters.size(); ++i) {
    const std::string& symbol = scene.mechanism.parameters[i].symbol;
    if (!scene.values.given[i]) continue;
    setting.scene.emplace(symbol, i == free ? make_symbol(symbol) : make_number(scene.values.parameters[i]));
  }
  for (std::size_t i = 0; i < scene.mechanism.angles.size(); ++i) {
    setting.scene.emplace(scene.mechanism.angles[i].cosine, make_number(scene.values.angles[i].cosine));
    setting.scene.emplace(scene.mechanism.angles[i].sine, make_number(scene.values.angles[i].sine));
  }
  const PlacedExpression& domain = scene.mechanism.parameters[free].domain;
  setting.parameters.push_back(
      {.symbol = parameter, .domain = domain ? setting.in_paper(domain.expression) : make_truth(true), .meaning = {}});
  setting.force.domain = make_truth(true);
  if (const auto& load = scene.mechanism.load) {
    setting.force.symbol = load->symbol;
    setting.scene.emplace(load->symbol, make_symbol(load->symbol));
    for (const PlacedExpression& bound : load->domain) {
      setting.force.domain = conjunction(setting.force.domain, setting.in_paper(bound.expression));
    }
  }
  return setting;
}

}  // namespace slipproof
