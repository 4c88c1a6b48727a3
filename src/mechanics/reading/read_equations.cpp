#include <algorithm>

#include "mechanics/reading/reader.hpp"

namespace slipproof::mechanism_reader {

namespace {

/// Splits `left = right`. Reports anything else, and leaves both sides null.
void split_equation(const TomlValue& value, MechanismEquation& equation, Context& context) {
  const PlacedExpression whole = context.expression(value, equation.name, Sort::truth);
  equation.left.text = equation.right.text = whole.text;
  if (!whole) return;
  const Node& node = *whole.expression;
  if (node.operation != Operation::compare || node.relations != std::vector{Relation::equal}) {
    context.refuse(whole, whole.expression, equation.name,
                   "found " + in_quotes(whole.text.text()) + ", expected an equation such as \"m*ax = F\"");
    context.sound = false;
    return;
  }
  equation.left.expression = node.operands[0];
  equation.right.expression = node.operands[1];
}

void read_motion(const TomlValue& motion, Context& context) {
  Mechanism& mechanism = context.mechanism;
  mechanism.by_virtual_work = true;
  std::vector<std::string_view> keys;
  for (std::size_t i = 0; i < mechanism.accelerations; ++i) keys.push_back(mechanism.unknowns[i].symbol);
  for (const TomlEntry& entry : motion.entries) {
    if (std::find(keys.begin(), keys.end(), entry.key) != keys.end()) continue;
    context.mistakes.add(entry.place, "motion: " + unknown_name("acceleration", entry.key, keys));
  }
  for (const std::string_view key : keys) {
    const TomlEntry* entry = motion.find(key);
    MechanismEquation equation;
    equation.name = std::string(key);
    if (entry == nullptr) {
      context.mistakes.add(motion.place, "missing " + equation.name + " in [motion], expected its equation of motion");
      context.sound = false;
    } else {
      split_equation(entry->value, equation, context);
    }
    mechanism.equations.push_back(std::move(equation));
  }
  if (mechanism.forces == 0) return;
  const MechanismUnknown& force = mechanism.unknowns[mechanism.accelerations];
  context.mistakes.add(force.place,
                       "forces: found the force " + force.symbol +
                           ", for which [motion] has no equation: expected a [[link]] for it, or [equations]");
}

void read_free_equations(const TomlValue& equations, Context& context) {
  Mechanism& mechanism = context.mechanism;
  for (const TomlEntry& entry : equations.entries) {
    MechanismEquation equation;
    equation.name = entry.key;
    split_equation(entry.value, equation, context);
    mechanism.equations.push_back(std::move(equation));
  }
  const std::size_t expected = mechanism.accelerations + mechanism.forces;
  if (mechanism.equations.size() == expected || expected == 0) return;
  context.mistakes.add(equations.place, "equations: found " + std::to_string(mechanism.equations.size()) +
                                            ", expected " + std::to_string(expected) + ": one for each of [unknowns]");
}

void read_units(const TomlValue& units, Context& context) {
  std::vector<std::string_view> keys;
  for (const MechanismUnknown& unknown : context.mechanism.unknowns) keys.push_back(unknown.symbol);
  const TableReader table(units, "[units]", keys, context.mistakes);
  for (MechanismUnknown& unknown : context.mechanism.unknowns) unknown.unit = context.text(table, unknown.symbol);
}

}  // namespace

void read_equations(const TableReader& root, Context& context) {
  const TomlValue* motion = root.table("motion");
  const TomlValue* equations = root.table("equations");
  if (root.has("motion") && root.has("equations")) {
    root.refuse("equations", "found together with [motion], expected one of them");
  } else if (!root.has("equations")) {
    root.require("motion", "the equations of motion in [motion] or [equations]");
  }
  if (motion != nullptr) {
    read_motion(*motion, context);
  } else if (equations != nullptr &&
             within(equations->entries.size(), 2 * max_unknowns, "equations", equations->place, context.mistakes)) {
    read_free_equations(*equations, context);
  }
  if (const TomlValue* units = root.table("units")) read_units(*units, context);
  context.mechanism.energy = context.expression(root, "energy", Sort::number);
  if (root.has("energy") && root.has("equations")) {
    root.refuse("energy", "found together with [equations], whose rows may be any sums of others, expected [motion]");
  }
}

}  // namespace slipproof::mechanism_reader
