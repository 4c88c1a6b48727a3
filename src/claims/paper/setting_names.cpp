#include "claims/paper/setting_names.hpp"

#include <algorithm>

namespace slipproof {

SettingNames::SettingNames(const Setting& setting) : setting_(&setting) {
  const std::vector<std::string> named = setting.quantities();
  quantities_ = named.size();
  for (std::size_t i = 0; i < named.size(); ++i) add(named[i], Kind::quantity, i);
  for (std::size_t i = 0; i < setting.parameters.size(); ++i) {
    if (!setting.parameters[i].angle) add(setting.parameters[i].symbol, Kind::parameter, i);
  }
  for (const FreeAngle& angle : setting.angles) {
    add(angle.cosine, Kind::parameter, angle.parameter);
    add(angle.sine, Kind::parameter, angle.parameter);
  }
  if (!setting.force.symbol.empty()) add(setting.force.symbol, Kind::force, 0);
  for (std::size_t i = 0; i < setting.definitions.size(); ++i) add(setting.definitions[i].symbol, Kind::definition, i);
  for (const Reading reading : all_readings) find_reach(reading);
}

std::size_t SettingNames::id(Entry entry) const {
  switch (entry.kind) {
    case Kind::quantity:
      return entry.index;
    case Kind::force:
      return quantities_;
    case Kind::parameter:
      return quantities_ + 1 + entry.index;
    case Kind::definition:
      return definitions() + entry.index;
  }
  return 0;
}

void SettingNames::find_reach(Reading reading) {
  const std::size_t count = setting_->definitions.size();
  std::vector<std::vector<std::size_t>> direct(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::string& symbol : symbols(definition(i, reading))) {
      if (const auto entry = find(symbol)) direct[i].push_back(id(*entry));
    }
  }
  auto& reach = reach_[static_cast<std::size_t>(reading)];
  reach.assign(count, std::vector<bool>(definitions() + count));
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<std::size_t> open = direct[i];
    while (!open.empty()) {
      const std::size_t next = open.back();
      open.pop_back();
      if (reach[i][next]) continue;
      reach[i][next] = true;
      if (next >= definitions())
        open.insert(open.end(), direct[next - definitions()].begin(), direct[next - definitions()].end());
    }
  }
}

std::optional<SettingNames::Entry> SettingNames::find(std::string_view name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() ? std::nullopt : std::optional(found->second);
}

const Expression& SettingNames::definition(std::size_t index, Reading reading) const {
  const Definition& definition = setting_->definitions[index];
  return reading == Reading::repaired && definition.repaired ? definition.repaired : definition.printed;
}

std::vector<bool> SettingNames::reach(const Expression& expression, Reading reading) const {
  std::vector<bool> reached(definitions() + setting_->definitions.size());
  for (const std::string& symbol : symbols(expression)) {
    const auto entry = find(symbol);
    if (!entry) continue;
    reached[id(*entry)] = true;
    if (entry->kind != Kind::definition) continue;
    const auto& more = reach_[static_cast<std::size_t>(reading)][entry->index];
    std::transform(reached.begin(), reached.end(), more.begin(), reached.begin(), std::logical_or<>());
  }
  return reached;
}

std::vector<std::size_t> SettingNames::needs(const Expression& expression, Reading reading) const {
  const std::vector<bool> reached = reach(expression, reading);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < setting_->definitions.size(); ++i) {
    if (reached[definitions() + i]) result.push_back(i);
  }
  return result;
}

bool SettingNames::depends(const Expression& expression, Reading reading, std::string_view symbol) const {
  const auto entry = find(symbol);
  return entry && reach(expression, reading)[id(*entry)];
}

bool SettingNames::readings_differ(const Expression& expression) const {
  const auto needed = needs(expression, Reading::printed);
  return std::any_of(needed.begin(), needed.end(),
                     [&](std::size_t i) { return setting_->definitions[i].repaired != nullptr; });
}

}  // namespace slipproof
