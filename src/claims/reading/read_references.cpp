// Resolves references between claims when all claims are read, and adds the readings that follow from them.
#include <algorithm>
#include <array>

#include "claims/paper/setting_names.hpp"
#include "claims/reading/claims_reader.hpp"

namespace slipproof::claims_reader {

namespace {

constexpr std::array<std::pair<std::string_view, References ClaimBody::*>, 3> lists{
    {{"claims", &ClaimBody::claims}, {"except", &ClaimBody::except}, {"given", &ClaimBody::given}}};

/// Checks that `part_of` names a definition with a repair, or another finding.
void check_part(const ClaimsFile& file, Context& context, const Claim& claim, const PlacedText& id) {
  for (const Setting& setting : file.settings) {
    for (const Definition& definition : setting.definitions) {
      if (definition.repaired && slipproof::id(definition) == id.text()) return;
    }
  }
  const Claim* found = file.find(id.text());
  if (found != nullptr && found != &claim && found->grade && found->part_of.empty()) return;
  context.refuse(id, 0, "part_of",
                 "found " + in_quotes(id.text()) +
                     ", expected another claim with a grade and no part_of, or EQUATION.SYMBOL of a definition "
                     "with a repair");
}

/// The kinds of claims that a key may refer to, if the other claim has none of them.
std::string misfit(const ClaimField& field, const Claim& other) {
  std::string expected;
  for (const std::string_view kind : field.kinds) {
    if (kind == other.kind().name()) return "";
    expected += (expected.empty() ? "" : " or ") + std::string(kind);
  }
  return expected;
}

void resolve_one(Context& context, const Claim& claim, const PlacedText& id, std::string_view key, References& list) {
  const auto& claims = context.file.claims;
  const Claim* found = context.file.find(id.text());
  if (found == nullptr) {
    std::vector<std::string_view> ids;
    for (const Claim& other : claims) ids.push_back(other.id);
    return context.refuse(id, 0, key, unknown("claim", id.text(), ids));
  }
  std::string expected = misfit(*claim.kind().field(key), *found);
  if (expected.empty() && found->setting != claim.setting) expected = found->kind().name();
  if (!expected.empty()) {
    return context.refuse(
        id, 0, key,
        "found " + in_quotes(id.text()) + ", expected a claim of kind " + expected + " in the same setting");
  }
  list.push_back(static_cast<std::size_t>(found - claims.data()));
}

/// Adds a repaired reading to each claim that builds on a definition or claim with a repaired reading. Returns, by
/// claim, whether it did.
std::vector<bool> add_implied_readings(ClaimsFile& file) {
  auto& claims = file.claims;
  std::vector<SettingNames> names;
  for (const Setting& setting : file.settings) names.emplace_back(setting);
  const auto builds_on_repair = [&](const Claim& claim) {
    const auto all = expressions(claim.printed);
    const References others = claim.printed.references();
    return std::any_of(
               all.begin(), all.end(),
               [&](const Expression& e) { return !names.empty() && names[claim.setting].readings_differ(e); }) ||
           std::any_of(others.begin(), others.end(), [&](std::size_t i) { return claims[i].repaired.has_value(); });
  };
  std::vector<bool> implied(claims.size());
  for (bool more = true; more;) {  // follows references until no further claim gets a reading
    more = false;
    for (std::size_t i = 0; i < claims.size(); ++i) {
      implied[i] = builds_on_repair(claims[i]);
      if (!implied[i] || claims[i].repaired) continue;
      more = true;
      claims[i].repaired = claims[i].printed;
      claims[i].repaired->expect = Expectation::none;
    }
  }
  return implied;
}

}  // namespace

void OpenReferences::add(const TableReader& table, std::size_t claim, Reading reading, const ClaimKind& kind) {
  for (const auto& [key, list] : lists) {
    if (kind.has(key) && table.has(key)) texts_.push_back({claim, reading, key, list, table.strings(key)});
  }
}

void OpenReferences::resolve(Context& context) const {
  ClaimsFile& file = context.file;
  for (const Texts& texts : texts_) {
    Claim& claim = file.claims[texts.claim];
    ClaimBody& body = texts.reading == Reading::printed ? claim.printed : *claim.repaired;
    for (const PlacedText* id : texts.ids) resolve_one(context, claim, *id, texts.key, body.*texts.list);
  }
  for (Claim& claim : file.claims) {  // a repair that names no claims refers to those of the print
    if (!claim.repaired) continue;
    for (const auto& [key, list] : lists) {
      if (((*claim.repaired).*list).empty()) (*claim.repaired).*list = claim.printed.*list;
    }
  }
  const std::vector<bool> implied = add_implied_readings(file);
  for (const auto& [claim, place] : only_expecting_) {
    if (implied[claim]) continue;
    context.mistakes.add(place,
                         "repaired: found a reading that changes nothing, and no definition that it uses has a repair, "
                         "expected a key of the claim with another value");
  }
  for (const auto& [claim, id] : parts_) check_part(file, context, file.claims[claim], *id);
}

}  // namespace slipproof::claims_reader
