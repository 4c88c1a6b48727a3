#include "mechanics/family/free.hpp"

#include <stdexcept>

#include "base/input/diagnostic.hpp"

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

Family with_free(const MechanismScene& scene, const std::string& parameter) {
  const std::size_t free = given_parameter(scene, parameter);
  Family family;
  family.mechanism = std::make_shared<const Mechanism>(scene.mechanism);
  family.starts = scene.values.starts;
  const Mechanism& mechanism = *family.mechanism;
  for (std::size_t i = 0; i < mechanism.parameters.size(); ++i) {
    if (!scene.values.given[i]) continue;
    const std::string& symbol = mechanism.parameters[i].symbol;
    family.scene.emplace(symbol, i == free ? make_symbol(symbol) : make_number(scene.values.parameters[i]));
  }
  for (std::size_t i = 0; i < mechanism.angles.size(); ++i) {
    family.scene.emplace(mechanism.angles[i].cosine, make_number(scene.values.angles[i].cosine));
    family.scene.emplace(mechanism.angles[i].sine, make_number(scene.values.angles[i].sine));
  }
  const PlacedExpression& domain = mechanism.parameters[free].domain;
  family.parameters.push_back({parameter, domain ? family.in_family(domain.expression) : make_truth(true)});
  family.force.domain = make_truth(true);
  if (!mechanism.load) return family;
  family.force.symbol = mechanism.load->symbol;
  family.scene.emplace(mechanism.load->symbol, make_symbol(mechanism.load->symbol));
  family.restrict_force_to_load();
  return family;
}

}  // namespace slipproof
