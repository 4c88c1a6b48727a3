#include "statements/setting_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "statements/truth_text.hpp"

namespace slipproof {

bool SettingWriter::is_true(const Expression& truth) {
  return !truth || (truth->operation == Operation::truth && truth->truth);
}

std::string SettingWriter::header(const std::string& theorem, const std::string& comment) {
  defined_.clear();
  return fmt::format("slipproof-statement 1\ntheorem {}\n# {}\n", theorem, comment);
}

std::string SettingWriter::assumption(const std::string& label, const Expression& truth) {
  return is_true(truth) ? "" : fmt::format("assume {}: {}\n", label, text(truth));
}

MotionText SettingWriter::motion(ContactMode mode) {
  complete_ = complete_ && (mode.on_road() || has_pitch_inertia());
  return {mechanics_text(setting_.force_kind) + state_definition(Wheel::rear, mode.rear, setting_.strict) +
              state_definition(Wheel::front, mode.front, setting_.strict),
          std::string(dynamics) + " and " + mode_text(mode)};
}

MotionText SettingWriter::equations(std::optional<ContactMode> mode) const {
  const std::string contacts =
      mode ? contact_equations(Wheel::rear, mode->rear) + " and " + contact_equations(Wheel::front, mode->front)
           : "gap2 = 0 and gap3 = 0";
  return {mechanics_text(setting_.force_kind), std::string(dynamics) + " and " + contacts};
}

MotionText SettingWriter::any_motion() const {
  MotionText result{mechanics_text(setting_.force_kind), dynamics};
  for (const Wheel wheel : {Wheel::rear, Wheel::front}) {
    std::vector<std::string> names;
    for (const ContactState state : all_contact_states) {
      result.definitions += state_definition(wheel, state, false);
      names.push_back(state_name(wheel, state));
    }
    result.formula += fmt::format(" and {{{}}}", fmt::join(names, " or "));
  }
  return result;
}

std::string SettingWriter::text(const Expression& truth) {
  const auto result = truth_text(truth);
  complete_ = complete_ && result;
  return result.value_or("");
}

std::string SettingWriter::parameters() const {
  std::string result;
  for (const Parameter& parameter : setting_.parameters) result += parameter.symbol + ' ';
  return result + setting_.force.symbol;
}

std::string SettingWriter::domain(bool with_force) {
  std::vector<std::string> parts;
  for (const Parameter& parameter : setting_.parameters) {
    if (!is_true(parameter.domain)) parts.push_back(text(parameter.domain));
  }
  if (with_force && !is_true(setting_.force.domain)) parts.push_back(text(setting_.force.domain));
  return fmt::format("{}", fmt::join(parts, " and "));
}

std::string SettingWriter::definitions(const std::vector<Expression>& uses) {
  std::string result;
  for (const Expression& use : uses) {
    if (!use) continue;
    for (const std::string& symbol : symbols(use)) {
      const auto found = std::find_if(setting_.definitions.begin(), setting_.definitions.end(),
                                      [&](const Definition& d) { return d.symbol == symbol; });
      if (found == setting_.definitions.end() || !defined_.insert(symbol).second) continue;
      const Expression& value = reading_ == Reading::repaired && found->repaired ? found->repaired : found->printed;
      result += definitions({value});
      result += fmt::format("let {} = {}\n", symbol, to_string(value));
      // A symbol of the scene may only be defined as what it is there.
      const auto in_scene = setting_.scene.find(symbol);
      if (in_scene != setting_.scene.end() && !same(in_scene->second, value)) give_up();
    }
  }
  return result;
}

std::string SettingWriter::scene(const std::vector<Expression>& uses) {
  std::vector<Expression> all = uses;
  for (const auto& [symbol, value] : setting_.scene) all.push_back(value);
  std::string result = definitions(all);
  const bool free = std::any_of(setting_.parameters.begin(), setting_.parameters.end(),
                                [](const Parameter& parameter) { return parameter.symbol == "J"; });
  if (!has_pitch_inertia() && !free) result += "let J = 0\n";
  for (const auto& [symbol, value] : setting_.scene) {
    if (to_string(value) != symbol && defined_.insert(symbol).second) {
      result += fmt::format("let {} = {}\n", symbol, to_string(value));
    }
  }
  return result;
}

}  // namespace slipproof
