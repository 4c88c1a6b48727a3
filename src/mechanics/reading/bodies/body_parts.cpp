#include "mechanics/reading/bodies/body_parts.hpp"

#include <algorithm>

#include "mechanics/mechanism/algebra.hpp"

namespace slipproof::mechanism_reader {

PlacedVector BodyParts::vector(const TableReader& table, std::string_view key) {
  const TomlValue* value = table.value(key);
  return value == nullptr ? PlacedVector{} : vector(*value, key);
}
PlacedVector BodyParts::vector(const TomlValue& value, std::string_view key) {
  auto all = coordinates(value, key);
  all.resize(3);
  if (in_space()) {
    for (PlacedExpression& one : all) fold(one);
  }
  return {std::move(all[0]), std::move(all[1]), std::move(all[2]), value.place};
}
PlacedVector BodyParts::turning(const TableReader& table, std::string_view key) {
  if (in_space()) return vector(table, key);
  return {{}, {}, one(table, key), table.place(key)};
}
PlacedExpression BodyParts::one(const TableReader& table, std::string_view key) {
  PlacedExpression result = context_.expression(table, key, Sort::number);
  if (in_space()) fold(result);
  return result;
}
PlacedExpression BodyParts::folded_number(const TomlValue& value, std::string_view key) {
  PlacedExpression result = context_.expression(value, key, Sort::number);
  fold(result);
  return result;
}
/// Numbers of a scene in space, of which there may be many, are computed with before anything is derived.
void BodyParts::fold(PlacedExpression& placed) {
  if (placed) placed.expression = folded(placed.expression);
}

std::optional<std::size_t> BodyParts::find_body(const PlacedText& name, std::string_view key) {
  std::vector<std::string_view> known;
  for (std::size_t i = 0; i < bodies_.bodies.size(); ++i) {
    if (bodies_.bodies[i].name == name.text()) return i;
    if (!bodies_.bodies[i].name.empty()) known.push_back(bodies_.bodies[i].name);
  }
  context_.sound = false;
  if (!context_.bodies_named_well) return std::nullopt;  // it may be the one whose name is a mistake
  context_.mistakes.add(name.at(0), std::string(key) + ": " + unknown_name("body", name.text(), known));
  return std::nullopt;
}

std::size_t BodyParts::body_of(const TableReader& table, std::string_view key) {
  if (!table.require(key, "the name of a body")) return failed();
  const PlacedText* name = table.string(key);
  return name == nullptr ? failed() : find_body(*name, key).value_or(ground);
}
std::size_t BodyParts::failed() {
  context_.sound = false;
  return ground;
}

std::pair<std::size_t, std::size_t> BodyParts::read_between(const TableReader& table) {
  if (!table.require("between", "the names of two bodies")) return {failed(), ground};
  const auto names = table.strings("between");
  if (names.size() != 2) {
    if (table.value("between")->kind == TomlValue::Kind::array) {
      table.refuse("between", "found " + std::to_string(names.size()) + " names, expected two");
    }
    return {failed(), ground};
  }
  const auto first = find_body(*names[0], "between"), second = find_body(*names[1], "between");
  if (!first || !second) return {failed(), ground};
  if (*first == *second)
    table.refuse("between", "found the body " + in_quotes(names[0]->text()) + " twice, expected two bodies");
  return {*first, *second};
}

bool BodyParts::turns(std::initializer_list<std::size_t> bodies) const {
  return std::ranges::any_of(bodies, [&](std::size_t i) { return bodies_.bodies[i].turns_freely(); });
}

TableReader BodyParts::names_of(const TableReader& table, std::span<const std::string_view> keys) {
  const TomlValue* names = table.value("names") == nullptr ? nullptr : table.table("names");
  return names == nullptr ? table : TableReader(*names, "names", keys, context_.mistakes);
}

void BodyParts::name_forces(const TableReader& names, MechanismContact& contact, std::size_t index) {
  using Role = MechanismUnknown::Role;
  const std::string& name = contact.name;
  contact.normal = unknown(names, "N", "N_" + name, Role::normal, index);
  contact.gap_name = named(names, "gap", "gap_" + name);
  if (contact.frictionless()) {
    for (const std::string_view key : {"S", "T1", "T2"}) {
      if (names.has(key)) names.refuse(key, "found the name of a force that a frictionless contact does not have");
    }
    return;
  }
  contact.tangent = unknown(names, in_space() ? "T1" : "S", (in_space() ? "T1_" : "S_") + name, Role::tangent, index);
  contact.slip_name = named(names, "slip", "slip_" + name);
  if (!in_space()) return;
  MechanismSlip second;
  second.force = unknown(names, "T2", "T2_" + name, Role::tangent, index);
  second.name = named(names, "slip2", "slip2_" + name);
  contact.second = std::move(second);
}

}  // namespace slipproof::mechanism_reader
