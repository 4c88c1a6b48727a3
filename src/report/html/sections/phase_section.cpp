#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/number/format.hpp"
#include "claims/planes/claims_plane.hpp"
#include "mechanics/planes/mechanism_plane.hpp"
#include "report/html/sections.hpp"
#include "report/markup/symbol.hpp"

namespace slipproof {

namespace {

constexpr std::size_t paper_columns = 240, scene_columns = 120;

/// `R = 1, h = 2, ...`: the fixed parameters.
std::string fixed_values(const ClaimsFile& claims, const Figure& figure) {
  std::string text;
  const auto& parameters = claims.settings[figure.setting].parameters;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    if (k == figure.x) continue;
    text += (text.empty() ? "" : ", ") + plain_symbol(parameters[k].symbol) + " = " + exact_text(figure.values[k]);
  }
  return text;
}

/// An id by the scene's name, so that links to it stay right when scenes are added: `scene-city-bicycle`.
std::string scene_id(std::string_view scene, std::vector<std::string>& taken) {
  std::string id = "scene";
  bool gap = true;
  for (const char c : scene) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    if (plain && gap) id += '-';
    if (plain) id += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    gap = !plain;
  }
  const std::string first = id;
  for (int number = 2; std::find(taken.begin(), taken.end(), id) != taken.end(); ++number) {
    id = first + "-" + std::to_string(number);
  }
  taken.push_back(id);
  return id;
}

}  // namespace

void add_phase_section(const Element& main, const PageInput& input) {
  if (input.figures.empty() && input.scenes.empty()) return;
  const Element section = add_section(main, "phase", "Phase diagrams");
  section.add("p", "lead")
      .text(std::string("Which motions there are, for every force at once. ") +
            (noun(*input.claims) == "bicycle"
                 ? "A mode is written rear/front: each wheel sticks (rolls), slips forwards (slip+) or backwards "
                   "(slip-), or lifts off the road."
                 : "A mode is a state of each contact, in the order of the mechanism's file: it sticks, slips with the "
                   "sign of its slip (slip+, slip-), touches without friction, or opens (lift).") +
            " In each of the columns that a diagram is made of, all limits are exact rationals; between columns the "
            "regions are joined up. Point at a diagram, or focus it and use the arrow keys, to read the exact motions "
            "at a point.");
  for (const Figure& figure : input.figures) {
    const PhaseDiagram diagram = phase_diagram(claims_plane(*input.claims, figure, Reading::printed), paper_columns);
    std::string caption = figure.note.empty() ? "" : figure.note + " ";
    caption += "For " + fixed_values(*input.claims, figure) + ". " + std::to_string(diagram.columns.size()) +
               " columns, exact in each.";
    const std::string link = input.explorer.empty() ? "" : link_to_explorer(input, figure_scene(*input.claims, figure));
    add_phase_figure(section, {diagram, caption, false, link});
  }
  if (input.scenes.empty()) return;
  section.add("h3", "on-demand").text("The scenes of cases/, in the plane of friction and force");
  const Element grid = section.add("div", "grid on-demand");
  std::vector<std::string> ids;
  for (const MechanismScene& scene : input.scenes) {
    const PhaseDiagram diagram = phase_diagram(mechanism_plane(scene, {}, scene_id(scene.name, ids)), scene_columns);
    std::string caption = diagram.plane.note;
    if (scene.load) caption += std::string(caption.empty() ? "" : " ") + "The dot is the scene itself.";
    add_phase_figure(grid, {diagram, caption, true, link_to_explorer(input, scene)});
  }
}

}  // namespace slipproof
