#include "claims/lines/line_bicycle.hpp"

#include <functional>
#include <initializer_list>

#include "mechanics/bicycle/conditions.hpp"
#include "mechanics/bicycle_modes/bicycle_motions.hpp"

namespace slipproof {

namespace {

using Values = std::initializer_list<std::reference_wrapper<const LineFunction>>;

IntegerPolynomial common_denominator(const Values& values) {
  IntegerPolynomial result(1);
  for (const LineFunction& value : values) result = least_common_multiple(result, value.denominator().front());
  return result;
}

/// The coefficient of a power of the force, times a multiple of the denominator.
IntegerPolynomial times(const LineFunction& value, const IntegerPolynomial& multiple, std::size_t power = 0) {
  if (power >= value.numerator().size()) return 0;
  return scaled(value.numerator()[power], multiple, value.denominator().front());
}

}  // namespace

IntegerPolynomial LineScene::unit(Quantity quantity) const {
  switch (quantity) {
    case Quantity::phi:
    case Quantity::eps2:
    case Quantity::eps3:
      return rate;
    case Quantity::S2:
    case Quantity::S3:
    case Quantity::N2:
    case Quantity::N3:
      return mass * length * rate;
    default:
      return length * rate;
  }
}

namespace {

/// Nothing where something has no value.
std::optional<SceneAlongLine> values_along(const CompiledSetting& setting, LineEvaluator& paper) {
  const CompiledScene& scene = setting.scene();
  SceneAlongLine result;
  bool complete = true;
  const auto read = [&](std::string_view symbol, LineFunction& number) {
    auto value = paper.number(*scene.parameters[bicycle_parameter(symbol)]).number;
    complete = complete && value && value->without_force();
    if (complete) number = std::move(*value);
  };
  for_each_number(result.bicycle, result.road, read);
  if (scene.parameters[bicycle_parameter("J")]) read("J", result.bicycle.J.emplace());
  auto force = paper.number(*scene.load).number;
  if (!complete || !force) return std::nullopt;
  result.force = std::move(*force);
  return result;
}

std::optional<LineScene> line_scene(const SceneAlongLine& values) {
  const auto& [p, road, F] = values;
  if (F.numerator().size() != 2 || F.denominator().size() != 1) return std::nullopt;
  LineScene s;
  s.length = common_denominator({p.R, p.h, p.b2, p.b3, p.L});
  const LineFunction length(s.length), area(s.length * s.length);
  const LineFunction I1 = p.I1 * area, I2 = p.I2 * area, I3 = p.I3 * area;
  const LineFunction J = p.J ? *p.J * area : LineFunction();
  s.mass = common_denominator({p.M, I1, I2, I3, J});
  const LineFunction g = road.g * length;
  const LineFunction force = F * LineFunction(s.mass * s.length);
  s.rate = common_denominator({g, force});
  const IntegerPolynomial radius = common_denominator({p.r1, p.r2});
  s.bicycle = {.M = times(p.M, s.mass),
               .R = times(p.R, s.length),
               .h = times(p.h, s.length),
               .b2 = times(p.b2, s.length),
               .b3 = times(p.b3, s.length),
               .I1 = times(I1, s.mass),
               .I2 = times(I2, s.mass),
               .I3 = times(I3, s.mass),
               .r1 = times(p.r1, radius),
               .r2 = times(p.r2, radius),
               .L = times(p.L, s.length),
               .J = p.J ? std::optional(times(J, s.mass)) : std::nullopt};
  s.road = {.f = times(road.f, road.f.denominator().front()), .g = times(g, s.rate)};
  s.friction_denominator = road.f.denominator().front();
  s.force = {times(force, s.rate, 0), times(force, s.rate, 1)};
  return s;
}

}  // namespace

LineBicycle::LineBicycle(const CompiledSetting& setting, LineEvaluator& paper) : setting_(setting) {
  values_ = values_along(setting, paper);
  if (values_) scene_ = line_scene(*values_);
  if (!scene_) return;
  dynamics_ = reduce<IntegerPolynomial, Affine<IntegerPolynomial>>(scene_->bicycle, scene_->road, *setting.bicycle(),
                                                                   scene_->force, scene_->friction_denominator);
}

bool LineBicycle::add_mode(const MechanismMode& mode, const std::vector<std::size_t>& wanted, CriticalSet& found,
                           LineEvaluator& paper) const {
  const ContactMode contacts = *contact_mode(mode);
  if (!contacts.on_road() && !scene_->bicycle.J) return false;
  const LineMotion motion(*dynamics_, contacts);
  const auto spins = [&](ContactState state, const IntegerPolynomial& inertia) {
    if (state != ContactState::stick) found.add(inertia);
    return state == ContactState::stick || !inertia.is_zero();
  };
  found.add(motion.determinant());
  const bool rear = spins(contacts.rear, motion.rear_spin_inertia()),
             front = spins(contacts.front, motion.front_spin_inertia());
  if (motion.determinant().is_zero() || !rear || !front) return false;
  for (const Condition& condition : conditions(contacts)) found.add(motion.condition_numerator(condition));
  set_quantities(motion, wanted, paper);
  return true;
}

void LineBicycle::set_quantities(const LineMotion& motion, const std::vector<std::size_t>& wanted,
                                 LineEvaluator& paper) const {
  const auto value = [&](Quantity quantity) {
    auto v = motion.quantity(quantity);
    return LineFunction(v.numerator, v.denominator * scene_->unit(quantity));
  };
  const Bicycle<LineFunction>& p = values_->bicycle;
  const auto sprocket = [&] {  // by the chain, (2.4)
    return (p.r2 * value(Quantity::eps2) + (p.r1 - p.r2) * value(Quantity::phi)) / p.r1;
  };
  for (const std::size_t slot : wanted) {
    const std::string& name = setting_.scope().slots[slot].name;
    const auto quantity = parse_quantity(name);
    paper.set(slot, quantity         ? value(*quantity)
                    : name == "eps1" ? sprocket()
                                     : (p.I1 * sprocket() - p.L * values_->force) / p.r1);
  }
}

}  // namespace slipproof
