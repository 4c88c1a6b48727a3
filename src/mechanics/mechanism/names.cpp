#include "mechanics/mechanism/names.hpp"

#include <array>

#include "base/input/near_match.hpp"
#include "base/output/listed.hpp"

namespace slipproof {

std::string_view describe(NameKind kind) {
  constexpr std::array<std::string_view, 9> texts{"the parameter",     "the angle's symbol", "the definition",
                                                  "the load",          "the acceleration",   "the force",
                                                  "the contact force", "the gap or slip",    "the angle"};
  return texts[static_cast<std::size_t>(kind)];
}

namespace {

NameKind kind_of(MechanismUnknown::Role role) {
  if (role == MechanismUnknown::Role::acceleration) return NameKind::acceleration;
  return role == MechanismUnknown::Role::force ? NameKind::force : NameKind::element_force;
}

}  // namespace

MechanismNames::MechanismNames(const Mechanism& mechanism) {
  const auto add = [&](const std::string& name, NameKind kind, std::size_t index) {
    if (!name.empty()) entries_.try_emplace(name, Entry{kind, index});
  };
  for (std::size_t i = 0; i < mechanism.parameters.size(); ++i) {
    add(mechanism.parameters[i].symbol, NameKind::parameter, i);
  }
  for (std::size_t i = 0; i < mechanism.definitions.size(); ++i) {
    add(mechanism.definitions[i].symbol, NameKind::definition, i);
  }
  for (std::size_t i = 0; i < mechanism.angles.size(); ++i) {
    add(mechanism.angles[i].cosine, NameKind::angle, 2 * i);
    add(mechanism.angles[i].sine, NameKind::angle, 2 * i + 1);
    add(mechanism.angles[i].name, NameKind::angle_name, i);
  }
  if (mechanism.load) add(mechanism.load->symbol, NameKind::load, 0);
  for (std::size_t i = 0; i < mechanism.unknowns.size(); ++i) {
    add(mechanism.unknowns[i].symbol, kind_of(mechanism.unknowns[i].role), i);
  }
  const auto quantities = acceleration_names(mechanism);
  for (std::size_t i = mechanism.accelerations; i < quantities.size(); ++i) add(quantities[i], NameKind::quantity, i);
}

std::optional<MechanismNames::Entry> MechanismNames::find(std::string_view name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::string_view> MechanismNames::names(NameKinds kinds) const {
  std::vector<std::string_view> result;
  for (const auto& [name, entry] : entries_) {
    if (contains(kinds, entry.kind)) result.push_back(name);
  }
  return result;
}

std::vector<bool> definitions_with(const Mechanism& mechanism, const MechanismNames& names, std::string_view symbol) {
  std::vector<bool> result(mechanism.definitions.size());
  for (std::size_t i = 0; i < result.size(); ++i) {  // a definition uses only those before it
    if (!mechanism.definitions[i].expression) continue;
    for (const std::string& used : symbols(mechanism.definitions[i].expression.expression)) {
      const auto entry = names.find(used);
      const bool through = entry && entry->kind == NameKind::definition && result[entry->index];
      if (used == symbol || through) result[i] = true;
    }
  }
  return result;
}

std::string unknown_name(std::string_view what, std::string_view found, const std::vector<std::string_view>& known) {
  std::string message = "unknown " + std::string(what) + " " + in_quotes(found);
  const auto meant = near_match(found, known);
  if (meant) message += ", did you mean '" + std::string(*meant) + "'?";
  constexpr std::size_t most = 60;
  if (known.empty() || known.size() > most) return message;
  const char* const one = known.size() == 1 ? "expected " : "expected one of ";
  return message + (meant ? " " : ", ") + one + listed(known);
}

}  // namespace slipproof
