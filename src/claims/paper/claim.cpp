#include "claims/paper/claim.hpp"

#include <algorithm>
#include <array>

namespace slipproof {

std::string_view name(Grade grade) {
  constexpr std::array<std::string_view, 4> names{"misprint", "gap", "boundary", "false"};
  return names[static_cast<std::size_t>(grade)];
}

std::string_view name(Expectation expectation) {
  constexpr std::array<std::string_view, 5> names{"none", "holds", "refuted", "undecided", "vacuous"};
  return names[static_cast<std::size_t>(expectation)];
}

std::string_view name(BodyPart part) {
  constexpr std::array<std::string_view, 5> names{"region", "forces", "holds", "equation", "assumption"};
  return names[static_cast<std::size_t>(part)];
}

References ClaimBody::references() const {
  References all = given;
  all.insert(all.end(), claims.begin(), claims.end());
  all.insert(all.end(), except.begin(), except.end());
  return all;
}

std::vector<Expression> expressions(const ClaimBody& body) {
  std::vector<Expression> all;
  for_each_part(body, [&](BodyPart, std::size_t, const Expression& expression) { all.push_back(expression); });
  return all;
}

const ClaimField* ClaimKind::field(std::string_view key) const {
  const auto found = std::find_if(traits_.fields.begin(), traits_.fields.end(),
                                  [&](const ClaimField& field) { return field.key == key; });
  return found == traits_.fields.end() ? nullptr : &*found;
}

Modes ClaimKind::moving(const ClaimBody&) const {
  return {};
}
std::string ClaimKind::why_unstated(const ClaimBody&) const {
  return {};
}
bool ClaimKind::may_be_identity(const ClaimBody&) const {
  return false;
}
std::string ClaimKind::failing(const ClaimBody&, const Judgement&, std::string_view) const {
  return {};
}

}  // namespace slipproof
