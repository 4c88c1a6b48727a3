#include "mechanics/family/freed_scene.hpp"

#include <algorithm>
#include <stdexcept>

#include "base/input/diagnostic.hpp"
#include "mechanics/mechanism/names.hpp"
#include "mechanics/points/degrees.hpp"

namespace slipproof {

FreeSymbol find_symbol(const MechanismScene& scene, const std::string& symbol) {
  const Mechanism& mechanism = scene.mechanism;
  std::vector<std::string_view> known;
  for (std::size_t i = 0; i < mechanism.parameters.size(); ++i) {
    const MechanismParameter& parameter = mechanism.parameters[i];
    if (parameter.symbol == symbol && !scene.values.given[i]) {
      throw std::invalid_argument("the scene has no " + symbol);
    }
    if (parameter.symbol == symbol) return {symbol, parameter.unit, {}, scene.values.parameters[i], {{i, {0, 1}}}};
    known.push_back(parameter.symbol);
  }
  for (const CombinedParameter& combined : scene.combined) {
    known.push_back(combined.symbol);
    if (combined.symbol != symbol) continue;
    FreeSymbol free{symbol, combined.unit, {}, combined.value};
    for (const auto& [name, value] : combined.sets) {
      const auto same = std::ranges::find(mechanism.parameters, name, &MechanismParameter::symbol);
      free.sets.emplace_back(static_cast<std::size_t>(same - mechanism.parameters.begin()), value);
    }
    return free;
  }
  for (std::size_t i = 0; i < mechanism.angles.size(); ++i) {
    if (mechanism.angles[i].name == symbol) return {symbol, {}, i, {}};
    known.push_back(mechanism.angles[i].name);
  }
  if (mechanism.load && mechanism.load->symbol == symbol) {
    throw std::invalid_argument("found the load " + symbol +
                                " across, expected a parameter or an angle: the load goes up");
  }
  throw std::invalid_argument(unknown_name("parameter or angle", symbol, known));
}

FreeSymbol find_parameter(const MechanismScene& scene, const std::string& symbol) {
  const auto& all = scene.mechanism.parameters;
  std::vector<std::string_view> known;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!scene.values.given[i]) continue;
    if (all[i].symbol == symbol) return find_symbol(scene, symbol);
    known.push_back(all[i].symbol);
  }
  throw std::invalid_argument(unknown_name("parameter of the scene", symbol, known));
}

FreedScene::FreedScene(const MechanismScene& scene, FreeSymbol free, Tied tied)
    : mechanism_(std::make_shared<const Mechanism>(scene.mechanism)),
      values_(scene.values),
      free_(std::move(free)),
      tied_(tied),
      maker_(*mechanism_),
      sampler_(*mechanism_, maker_) {}

std::optional<Rational> FreedScene::own() const {
  if (!free_.angle) return free_.own;
  const MechanismValues::Circle& point = values_.angles[*free_.angle];
  if (point.cosine == -1) return std::nullopt;
  return Rational(point.sine / (1 + point.cosine));
}

MechanismValues FreedScene::values(const Rational& x) const {
  MechanismValues changed = values_;
  if (free_.angle) changed.angles[*free_.angle] = point_of_tan_half(x);
  for (const auto& [parameter, value] : free_.sets) changed.parameters[parameter] = value.at(x);
  const std::size_t kept = free_.angle ? changed.parameters.size() : free_.sets.front().first;
  if (tied_ == Tied::follow) sampler_.restore(changed, kept);
  return changed;
}

std::optional<FrictionProblem> FreedScene::problem(const Rational& x) const {
  const MechanismValues there = values(x);
  if (!sampler_.contains(there)) return std::nullopt;
  try {
    return maker_.problem(there);
  } catch (const NoValue&) {
    return std::nullopt;
  }
}

std::string FreedScene::broken(const Rational& x) const {
  const auto all = maker_.broken(values(x));
  return all.empty() ? std::string() : to_string(all.front().condition->expression);
}

std::vector<std::string> FreedScene::followers(const Rational& from, const Rational& to) const {
  std::vector<std::string> symbols;
  const MechanismValues left = values(from), right = values(to);
  for (std::size_t i = 0; i < values_.parameters.size(); ++i) {
    if (std::ranges::any_of(free_.sets, [&](const auto& set) { return set.first == i; })) continue;
    const Rational& own = values_.parameters[i];
    if (left.parameters[i] != own || right.parameters[i] != own) symbols.push_back(mechanism_->parameters[i].symbol);
  }
  return symbols;
}

Family FreedScene::family() const {
  Family family;
  family.mechanism = mechanism_;
  family.starts = values_.starts;
  for (std::size_t i = 0; i < mechanism_->parameters.size(); ++i) {
    const std::string& symbol = mechanism_->parameters[i].symbol;
    if (!values_.given[i]) continue;
    family.scene.emplace(symbol, symbol == free_.symbol ? make_symbol(symbol) : make_number(values_.parameters[i]));
  }
  for (std::size_t i = 0; i < mechanism_->angles.size(); ++i) {
    family.scene.emplace(mechanism_->angles[i].cosine, make_number(values_.angles[i].cosine));
    family.scene.emplace(mechanism_->angles[i].sine, make_number(values_.angles[i].sine));
  }
  const PlacedExpression& domain = mechanism_->parameters[free_.sets.front().first].domain;
  family.parameters.push_back({free_.symbol, domain ? family.in_family(domain.expression) : make_truth(true)});
  family.force.domain = make_truth(true);
  if (!mechanism_->load) return family;
  family.force.symbol = mechanism_->load->symbol;
  family.scene.emplace(mechanism_->load->symbol, make_symbol(mechanism_->load->symbol));
  family.restrict_force_to_load();
  return family;
}

}  // namespace slipproof
