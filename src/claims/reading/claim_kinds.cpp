#include "claims/reading/claim_kinds.hpp"

#include <array>
#include <utility>

namespace slipproof {

namespace {

template <class Visit, std::size_t... I>
void for_each_kind(Visit&& visit, std::index_sequence<I...>) {
  (visit(std::variant_alternative_t<I, ClaimKind>{}), ...);
}

template <class Visit>
void for_each_kind(Visit&& visit) {
  for_each_kind(visit, std::make_index_sequence<std::variant_size_v<ClaimKind>>{});
}

}  // namespace

std::string_view name(BodyPart part) {
  constexpr std::array<std::string_view, 5> names{"region", "forces", "holds", "equation", "assumption"};
  return names[static_cast<std::size_t>(part)];
}

std::string_view name(const ClaimKind& kind) {
  return std::visit([](const auto& one) { return one.name; }, kind);
}

std::optional<ClaimKind> parse_kind(std::string_view name) {
  std::optional<ClaimKind> found;
  for_each_kind([&](auto kind) {
    if (kind.name == name) found = std::move(kind);
  });
  return found;
}

std::vector<std::string_view> kind_names() {
  std::vector<std::string_view> names;
  for_each_kind([&](const auto& kind) { names.push_back(kind.name); });
  return names;
}

Modes modes(const ClaimKind& kind) {
  Modes found;
  for_each_field(kind, [&](std::string_view key, const auto& field, Need) {
    using Field = std::decay_t<decltype(field)>;
    if constexpr (std::is_same_v<Field, MechanismMode>) found.push_back(field);
    if constexpr (std::is_same_v<Field, std::optional<MechanismMode>>) {
      if (field) found.push_back(*field);
    }
    if constexpr (std::is_same_v<Field, Modes>) {
      if (key == "modes") found = field;
    }
  });
  return found;
}

References references(const ClaimKind& kind) {
  References found;
  for_each_field(kind, [&](std::string_view, const auto& field, Need) {
    if constexpr (std::is_same_v<std::decay_t<decltype(field)>, References>) {
      found.insert(found.end(), field.begin(), field.end());
    }
  });
  return found;
}

}  // namespace slipproof
