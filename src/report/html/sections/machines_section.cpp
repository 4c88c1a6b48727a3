#include <string>

#include "base/number/format.hpp"
#include "report/html/sections.hpp"
#include "report/uniqueness/uniqueness_svg.hpp"

namespace slipproof {

namespace {

constexpr int machine_digits = 4;

std::string critical_text(const std::optional<RealRoot>& value) {
  if (!value) return "never";
  if (value->is_rational()) return decimal_text(value->lower, machine_digits) + " = " + exact_text(value->lower);
  return "between " + decimal_text(value->lower, machine_digits) + " and " + decimal_text(value->upper, machine_digits);
}

}  // namespace

void add_machines_section(const Element& main, const PageInput& input) {
  if (input.machines.empty()) return;
  const Element section = add_section(main, "machines", "Numbers");
  section.add("p", "lead")
      .text(
          "From which coefficient of friction on a machine has several motions (at that coefficient itself perhaps "
          "infinitely many, or several under a single load), by the equations of its scene and without the claims of "
          "this page: under some push whatever, and under some load of its own.");
  ReportTable table{{"scene",
                     {"several under some push, from", true},
                     {"several under some load, from", true},
                     {"in the scene", true}}};
  table.label = "Critical friction of machines";
  for (const SceneAlong& machine : input.machines) {
    const std::string& name = machine.scene.name;
    const std::string link = link_to_explorer(input, machine.scene);
    table.row({link.empty() ? ReportLine(name) : ReportLine(link_to(name, link)),
               critical_text(machine.along.first_apart_for_some_q()), critical_text(machine.along.first_apart()),
               exact_text(machine.along.own)});
  }
  add_table(section, table);
  const SceneAlong& first = input.machines.front();
  if (!first.scene.mechanism.load) return;
  const PhaseDiagram diagram = uniqueness_diagram(first.scene, first.along);
  add_phase_figure(section, {diagram,
                             "Which motions there are around the critical value. " +
                                 std::to_string(diagram.columns.size()) + " columns, exact in each.",
                             false, link_to_explorer(input, first.scene)});
}

void add_open_section(const Element& main, const PageInput& input) {
  const std::vector<std::string>& open = input.claims->paper.open;
  if (open.empty()) return;
  const Element section = add_section(main, "open", "What remains open");
  const Element list = section.add("ul");
  for (const std::string& text : open) add_prose(list.add("li"), *input.claims, text);
}

}  // namespace slipproof
