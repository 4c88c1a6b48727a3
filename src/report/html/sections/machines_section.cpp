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

void add_machine(const Element& body, const SceneAlong& machine) {
  const Element row = body.add("tr");
  row.add("th").set("scope", "row").text(machine.scene.name);
  row.add("td", "number").text(critical_text(machine.along.first_apart_for_some_q()));
  row.add("td", "number").text(critical_text(machine.along.first_apart()));
  row.add("td", "number").text(exact_text(machine.along.own));
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
  const Element scroll = section.add("div", "scroll").set("tabindex", 0).set("role", "region");
  scroll.set("aria-label", "Critical friction of machines");
  const Element table = scroll.add("table");
  const Element head = table.add("thead").add("tr");
  for (const char* text : {"scene", "several under some push, from", "several under some load, from", "in the scene"})
    head.add("th").set("scope", "col").text(text);
  const Element body = table.add("tbody");
  for (const SceneAlong& machine : input.machines) add_machine(body, machine);
  const SceneAlong& first = input.machines.front();
  if (!first.scene.mechanism.load) return;
  const PhaseDiagram diagram = uniqueness_diagram(first.scene, first.along);
  add_phase_figure(section, {diagram, "Which motions there are around the critical value. " +
                                          std::to_string(diagram.columns.size()) + " columns, exact in each."});
}

void add_open_section(const Element& main, const PageInput& input) {
  const std::vector<std::string>& open = input.claims->paper.open;
  if (open.empty()) return;
  const Element section = add_section(main, "open", "What remains open");
  const Element list = section.add("ul");
  for (const std::string& text : open) add_prose(list.add("li"), input, text);
}

}  // namespace slipproof
