#include "support/bicycle/bicycle_motions.hpp"

#include <array>
#include <string_view>

namespace slipproof {

MechanismValues bicycle_values(const Bicycle<Rational>& p, const Road<Rational>& road, ForceKind kind) {
  MechanismValues values = default_values(bicycle_mechanism());
  const auto put = [&](std::string_view symbol, const Rational& value) {
    values.parameters[bicycle_parameter(symbol)] = value;
  };
  for_each_number(p, road, put);
  put("external", kind == ForceKind::external ? 1 : 0);
  put("J", p.J.value_or(0));
  values.given[bicycle_parameter("J")] = p.J.has_value();
  return values;
}

BicycleOfValues bicycle_of(const MechanismValues& values) {
  const auto value = [&](std::string_view symbol) -> const Rational& {
    return values.parameters[bicycle_parameter(symbol)];
  };
  BicycleOfValues result{{}, {}, value("external").is_zero() ? ForceKind::internal : ForceKind::external};
  for_each_number(result.bicycle, result.road,
                  [&](std::string_view symbol, Rational& number) { number = value(symbol); });
  if (values.given[bicycle_parameter("J")]) result.bicycle.J = value("J");
  return result;
}

const MechanismMode& mechanism_mode(ContactMode mode) {
  static const auto modes = [] {
    std::array<MechanismMode, 16> all;
    for (const ContactMode m : all_modes()) all[m.index()] = {m.rear, m.front};
    return all;
  }();
  return modes[mode.index()];
}

std::optional<ContactMode> contact_mode(const MechanismMode& mode) {
  const auto of_wheel = [](ElementState state) { return state <= ElementState::lift; };
  if (mode.size() != 2 || !of_wheel(mode[0]) || !of_wheel(mode[1])) return std::nullopt;
  return ContactMode{mode[0], mode[1]};
}

}  // namespace slipproof
