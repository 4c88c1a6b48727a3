#include "mechanics/planes/plane_columns.hpp"

#include <algorithm>
#include <stdexcept>

#include "mechanics/kernel/motions_over_loads.hpp"
#include "mechanics/mechanism/names.hpp"
#include "mechanics/points/degrees.hpp"

namespace slipproof {

std::optional<Rational> PlaneColumns::own() const {
  if (!across_.angle) return across_.own;
  const MechanismValues::Circle& point = values_.angles[*across_.angle];
  if (point.cosine == -1) return std::nullopt;
  return Rational(point.sine / (1 + point.cosine));
}

MechanismValues PlaneColumns::values(const Rational& x) const {
  MechanismValues changed = values_;
  if (across_.angle) changed.angles[*across_.angle] = point_of_tan_half(x);
  for (const auto& [parameter, value] : across_.sets) changed.parameters[parameter] = value.at(x);
  sampler_.restore(changed, across_.angle ? changed.parameters.size() : across_.sets.front().first);
  return changed;
}

std::optional<FrictionProblem> PlaneColumns::problem(const Rational& x) const {
  const MechanismValues there = values(x);
  if (!sampler_.contains(there)) return std::nullopt;
  try {
    return maker_.problem(there);
  } catch (const NoValue&) {
    return std::nullopt;
  }
}

std::optional<PhaseColumn> PlaneColumns::column(const Rational& x) const {
  auto there = problem(x);
  if (!there) return std::nullopt;
  PhaseColumn column;
  column.cells = motions_over_loads(std::move(*there))->cells(Detail::modes);
  return column;
}

std::vector<LoadCell> PlaneColumns::numbers(const Rational& x) const {
  return motions_over_loads(*problem(x))->cells();
}

std::string PlaneColumns::broken(const Rational& x) const {
  const auto all = maker_.broken(values(x));
  return all.empty() ? std::string() : to_string(all.front().condition->expression);
}

std::vector<std::string> PlaneColumns::followers(const Rational& from, const Rational& to) const {
  std::vector<std::string> symbols;
  const MechanismValues left = values(from), right = values(to);
  for (std::size_t i = 0; i < values_.parameters.size(); ++i) {
    if (std::ranges::any_of(across_.sets, [&](const auto& set) { return set.first == i; })) continue;
    const Rational& own = values_.parameters[i];
    if (left.parameters[i] != own || right.parameters[i] != own) symbols.push_back(mechanism_.parameters[i].symbol);
  }
  return symbols;
}

AcrossVariable find_across(const MechanismScene& scene, const std::string& x) {
  const Mechanism& mechanism = scene.mechanism;
  std::vector<std::string_view> known;
  for (std::size_t i = 0; i < mechanism.parameters.size(); ++i) {
    const MechanismParameter& parameter = mechanism.parameters[i];
    if (parameter.symbol == x && !scene.values.given[i]) throw std::invalid_argument("the scene has no " + x);
    if (parameter.symbol == x) return {x, parameter.unit, {}, scene.values.parameters[i], {{i, {0, 1}}}};
    known.push_back(parameter.symbol);
  }
  for (const CombinedParameter& combined : scene.combined) {
    known.push_back(combined.symbol);
    if (combined.symbol != x) continue;
    AcrossVariable across{x, combined.unit, {}, combined.value};
    for (const auto& [symbol, value] : combined.sets) {
      const auto same = std::ranges::find(mechanism.parameters, symbol, &MechanismParameter::symbol);
      across.sets.emplace_back(static_cast<std::size_t>(same - mechanism.parameters.begin()), value);
    }
    return across;
  }
  for (std::size_t i = 0; i < mechanism.angles.size(); ++i) {
    if (mechanism.angles[i].name == x) return {x, {}, i, {}};
    known.push_back(mechanism.angles[i].name);
  }
  if (mechanism.load && mechanism.load->symbol == x) {
    throw std::invalid_argument("found the load " + x + " across, expected a parameter or an angle: the load goes up");
  }
  throw std::invalid_argument(unknown_name("parameter or angle", x, known));
}

}  // namespace slipproof
