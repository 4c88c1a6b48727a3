#include "support/bicycle/contact_mode.hpp"

#include <algorithm>

namespace slipproof {

namespace {
constexpr std::array<std::string_view, quantity_count> quantity_names{
    "a", "a_y", "phi", "eps2", "eps3", "S2", "S3", "N2", "N3", "gap2", "gap3", "slip2", "slip3"};

std::optional<ContactState> parse_state(std::string_view text) {
  const auto state = parse_element_state(text);
  if (!state || *state > ContactState::lift) return std::nullopt;
  return state;
}

}  // namespace

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
    case StateCondition::pushes:
      return "N" + j + " >= 0";
    case StateCondition::slips_forward:
      return "slip" + j + " >= 0";
    case StateCondition::slips_backward:
      return "slip" + j + " <= 0";
    case StateCondition::opens:
      return "gap" + j + " >= 0";
    default:
      return "|S" + j + "| <= f N" + j;
  }
}

}  // namespace slipproof
