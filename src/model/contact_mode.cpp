#include "model/contact_mode.hpp"

#include <algorithm>

namespace slipproof {

namespace {
constexpr std::array<std::string_view, 4> state_names{"stick", "slip+", "slip-", "lift"};
constexpr std::array<std::string_view, quantity_count> quantity_names{
    "a", "a_y", "phi", "eps2", "eps3", "S2", "S3", "N2", "N3", "gap2", "gap3", "slip2", "slip3"};

std::optional<ContactState> parse_state(std::string_view text) {
  const auto found = std::find(state_names.begin(), state_names.end(), text);
  if (found == state_names.end()) return std::nullopt;
  return static_cast<ContactState>(found - state_names.begin());
}

}  // namespace

std::string_view name(ContactState state) {
  return state_names[static_cast<std::size_t>(state)];
}

std::string name(ContactMode mode) {
  return std::string(name(mode.rear)) + '/' + std::string(name(mode.front));
}

std::string_view name(Quantity quantity) {
  return quantity_names[static_cast<std::size_t>(quantity)];
}

std::optional<ContactMode> parse_mode(std::string_view text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto rear = parse_state(text.substr(0, slash));
  if (!rear || slash == text.size()) return std::nullopt;
  const auto front = parse_state(text.substr(slash + 1));
  if (!front) return std::nullopt;
  return ContactMode{*rear, *front};
}

std::optional<Quantity> parse_quantity(std::string_view text) {
  for (const Quantity quantity : all_quantities()) {
    if (name(quantity) == text) return quantity;
  }
  return std::nullopt;
}

std::string name(const Condition& condition) {
  const std::string j = condition.wheel == Wheel::rear ? "2" : "3";
  switch (condition.kind) {
    case ConditionKind::normal:
      return "N" + j + " >= 0";
    case ConditionKind::friction_up:
    case ConditionKind::friction_dn:
      return "|S" + j + "| <= f N" + j;
    case ConditionKind::slip:
      return "slip" + j + (condition.state == ContactState::slip_forward ? " >= 0" : " <= 0");
    case ConditionKind::gap:
      return "gap" + j + " >= 0";
  }
  return {};
}

}  // namespace slipproof
