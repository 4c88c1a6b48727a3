#include "report/picture/motions_svg.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "report/picture/frame/panels.hpp"
#include "report/picture/mechanism_svg.hpp"

namespace slipproof {

namespace {

/// The coefficient of friction, if all contacts have the same parameter: `f = 4`.
std::string friction_text(const MechanismScene& scene, const NumberWords& numbers) {
  const Mechanism& mechanism = scene.mechanism;
  const auto is_of_all = [&](const MechanismParameter& parameter) {
    return std::ranges::all_of(mechanism.contacts, [&](const MechanismContact& contact) {
      return !contact.frictionless() && is_symbol(contact.kinetic_friction.expression, parameter.symbol);
    });
  };
  const auto found = std::ranges::find_if(mechanism.parameters, is_of_all);
  if (found == mechanism.parameters.end() || mechanism.contacts.empty()) return {};
  const auto index = static_cast<std::size_t>(found - mechanism.parameters.begin());
  return found->symbol + " " + numbers.value(scene.values.parameters[index]);
}

/// `F = 3 N, f = 4, 2 motions`.
std::string below_title(const MechanismScene& scene, const MotionsAtLoad& found, const NumberWords& numbers) {
  std::vector<std::string> parts;
  if (scene.mechanism.load && scene.load) parts.push_back(load_text(scene, numbers));
  if (std::string friction = friction_text(scene, numbers); !friction.empty()) parts.push_back(std::move(friction));
  parts.push_back(found.motions.empty() && found.continua.empty() ? "no motion" : counted_motions(found));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::vector<MotionAtLoad> drawn_motions(const MotionsAtLoad& found) {
  std::vector<MotionAtLoad> all = found.motions;
  for (const ContinuumAtLoad& continuum : found.continua) {
    MotionAtLoad motion;
    (continuum.strict ? motion.modes : motion.boundary_modes).push_back(continuum.mode);
    for (const Range& range : continuum.accelerations) {
      motion.accelerations.push_back(shown_value(range).value_or(Rational(0)));
    }
    motion.forces = continuum.forces;
    all.push_back(std::move(motion));
  }
  return all;
}

CommonLook common_look(const MechanismScene& scene, const std::vector<MotionAtLoad>& motions) {
  std::vector<Range> numbers;
  CommonLook look;
  for (const MotionAtLoad& motion : motions) {
    const std::vector<Range> shown = shown_numbers(scene, &motion);
    numbers.insert(numbers.end(), shown.begin(), shown.end());
    look.largest_force = std::max(look.largest_force, largest_force(scene, motion));
  }
  look.numbers.emplace(numbers);
  look.brief = true;
  return look;
}

std::string motions_svg_file(const MechanismScene& scene, const MotionsAtLoad& found) {
  const std::vector<MotionAtLoad> motions = drawn_motions(found);
  const CommonLook look = common_look(scene, motions);
  PanelSheet sheet{
      scene.name, below_title(scene, found, *look.numbers), {}, picture_height(scene, PanelSheet{}.height)};
  for (std::size_t i = 0; i < std::max<std::size_t>(motions.size(), 1); ++i) {
    const MotionAtLoad* const motion = i < motions.size() ? &motions[i] : nullptr;
    const bool single = i < found.motions.size();
    const std::string heading =
        motion == nullptr ? "" : fmt::format("{}: {}{}", i + 1, modes_text(*motion), single ? "" : " (continuum)");
    sheet.panels.push_back({heading, {}, [&, motion, heading](const Element& svg, LabelBox& seen) {
                              return add_mechanism(svg, scene, motion, motion == nullptr ? "no motion" : heading, look,
                                                   &seen);
                            }});
  }
  return panels_svg_file(sheet);
}

}  // namespace slipproof
