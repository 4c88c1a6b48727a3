#include "mechanics/reading/element_parts.hpp"

#include <algorithm>
#include <array>

namespace slipproof::mechanism_reader {

using Role = MechanismUnknown::Role;

std::vector<const TomlValue*> ElementParts::tables(const TableReader& root, std::string_view key, std::size_t limit) {
  auto found = root.tables(key);
  if (!within(found.size(), limit, key, root.place(key), context_.mistakes)) found.clear();
  return found;
}

std::string ElementParts::name_of(const TableReader& table) {
  const std::string name = context_.required(table, "name", "an identifier");
  named_well_ = !name.empty() && context_.declare_element(name, table.place("name"));
  return name;
}

std::string ElementParts::named(const TableReader& table, std::string_view key, const std::string& otherwise) {
  const std::string given = context_.text(table, key);
  const std::string name = given.empty() && !table.has(key) ? otherwise : given;
  if (table.has(key) ? !name.empty() : named_well_) {
    context_.declare(name, table.place(table.has(key) ? key : std::string_view("name")));
  }
  return name;
}

std::size_t ElementParts::unknown(const TableReader& table, std::string_view key, const std::string& otherwise,
                                  Role role, std::size_t owner) {
  const Place place = table.place(table.has(key) ? key : std::string_view("name"));
  mechanism_.unknowns.push_back({named(table, key, otherwise), role, owner, {}, place});
  return mechanism_.unknowns.size() - 1;
}

void ElementParts::read_coefficients(const TableReader& table, MechanismContact& contact) {
  const TomlValue* friction = table.value("friction");
  if (friction == nullptr) return;
  read_two(*friction, "friction", contact.static_friction, contact.kinetic_friction);
  if (friction->kind == TomlValue::Kind::table) return;
  if (contact.static_friction && is_literal_zero(contact.static_friction.expression)) {
    contact.static_friction.expression = contact.kinetic_friction.expression = nullptr;  // the checks tell by the text
  }
}

void ElementParts::read_two(const TomlValue& value, const std::string& key, PlacedExpression& at_rest,
                            PlacedExpression& in_slip) {
  if (value.kind == TomlValue::Kind::table) {
    static constexpr std::array<std::string_view, 2> keys{"static", "kinetic"};
    const TableReader table(value, key, keys, context_.mistakes);
    for (const std::string_view one : keys) {
      context_.sound = table.require(one, "an expression") && context_.sound;
    }
    at_rest = context_.expression(table, "static", Sort::number);
    in_slip = context_.expression(table, "kinetic", Sort::number);
  } else {
    at_rest = in_slip = context_.expression(value, key, Sort::number);
  }
  for (PlacedExpression* one : {&at_rest, &in_slip}) {
    if (!*one) one->expression = make_number(1);
  }
}

void ElementParts::read_contact_states(const TableReader& table, MechanismContact& contact) {
  contact.bilateral = table.boolean("bilateral").value_or(false);
  read_lift_needs(table, contact);
  read_state(table, contact.start,
             {.law = contact.frictionless() ? ElementKind::Law::frictionless : ElementKind::Law::coulomb,
              .bilateral = contact.bilateral});
}

void ElementParts::read_lift_needs(const TableReader& table, MechanismContact& contact) {
  std::vector<std::string_view> known;
  for (const MechanismParameter& parameter : mechanism_.parameters) {
    if (parameter.optional) known.push_back(parameter.symbol);
  }
  const auto names = table.strings("lift_needs");
  if (!within(names.size(), max_symbols, "lift_needs", table.place("lift_needs"), context_.mistakes)) return;
  for (const PlacedText* name : names) {
    for (std::size_t i = 0; i < mechanism_.parameters.size(); ++i) {
      const MechanismParameter& parameter = mechanism_.parameters[i];
      if (parameter.symbol == name->text() && parameter.optional) contact.lift_needs.push_back(i);
    }
    if (std::find(known.begin(), known.end(), name->text()) == known.end()) {
      context_.mistakes.add(name->at(0), "lift_needs: " + unknown_name("optional parameter", name->text(), known));
    }
  }
  if (contact.bilateral && table.has("lift_needs")) {
    table.refuse("lift_needs", "found a condition of lift, and a bilateral contact does not lift");
  }
}

void ElementParts::read_state(const TableReader& table, ElementKind::Start& start, const ElementKind& kind) {
  const PlacedText* text = table.string("state");
  if (text == nullptr) return;
  const auto found =
      read_start(text->text(), "state", table.place("state"), kind, mechanism_.dimension, context_.mistakes);
  start = found.value_or(start);
}

std::vector<PlacedExpression> ElementParts::coordinates(const TableReader& table, std::string_view key) {
  const TomlValue* value = table.value(key);
  return value == nullptr ? std::vector<PlacedExpression>{} : coordinates(*value, key);
}

std::vector<PlacedExpression> ElementParts::coordinates(const TomlValue& value, std::string_view key) {
  std::vector<PlacedExpression> result;
  if (value.kind != TomlValue::Kind::array || value.items.size() != mechanism_.dimension) {
    context_.mistakes.add(value.place, std::string(key) + (in_space()
                                           ? ": expected three coordinates such as [\"b\", \"0\", \"-h\"]"
                                           : ": expected two coordinates such as [\"b\", \"-h\"]"));
    return result;
  }
  for (const TomlValue& item : value.items) result.push_back(context_.expression(item, key, Sort::number));
  return result;
}

}  // namespace slipproof::mechanism_reader
