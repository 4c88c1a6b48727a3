#include "records/record/record_modes.hpp"

#include <algorithm>

#include "mechanics/kernel/mode_solver.hpp"

namespace slipproof {

RecordModes::RecordModes(std::vector<ElementKind> kinds)
    : kinds_(std::move(kinds)), has_all_(mode_count(kinds_) <= static_cast<double>(max_modes) - 1) {
  if (has_all_) {
    for (MechanismMode& mode : modes_of(kinds_)) add(std::move(mode));
  }
}

std::size_t RecordModes::size() const {
  const std::lock_guard lock(mutex_);
  return modes_.size();
}

const MechanismMode& RecordModes::mode(std::size_t number) const {
  const std::lock_guard lock(mutex_);
  return modes_[number];
}

const std::string& RecordModes::name(std::size_t number) const {
  const std::lock_guard lock(mutex_);
  return names_[number];
}

std::optional<std::uint16_t> RecordModes::find(std::string_view name) {
  const std::lock_guard lock(mutex_);
  if (const auto place = places_.find(name); place != places_.end()) return place->second;
  if (has_all_ || modes_.size() >= no_mode) return std::nullopt;
  auto mode = parsed(name);
  if (!mode) return std::nullopt;
  return add(std::move(*mode));
}

std::string RecordModes::example() const {
  if (has_all_) return name(std::min<std::size_t>(1, size() - 1));
  MechanismMode mode;
  for (const ElementKind& kind : kinds_) mode.push_back(states(kind).front());
  return slipproof::name(mode);
}

std::optional<MechanismMode> RecordModes::parsed(std::string_view text) const {
  MechanismMode mode;
  for (const ElementKind& kind : kinds_) {
    const std::size_t end = std::min(text.find('/'), text.size());
    const std::string_view word = text.substr(0, end);
    const std::vector<ElementState> own = states(kind);
    const auto state = std::find_if(own.begin(), own.end(), [&](ElementState s) { return slipproof::name(s) == word; });
    if (state == own.end() || (end == text.size()) != (mode.size() + 1 == kinds_.size())) return std::nullopt;
    mode.push_back(*state);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (!go_together(kinds_, mode)) return std::nullopt;
  return mode;
}

std::uint16_t RecordModes::add(MechanismMode mode) {
  const auto number = static_cast<std::uint16_t>(modes_.size());
  names_.push_back(slipproof::name(mode));
  modes_.push_back(std::move(mode));
  places_.emplace(names_.back(), number);
  return number;
}

}  // namespace slipproof
