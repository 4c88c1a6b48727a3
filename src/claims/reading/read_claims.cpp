#include <algorithm>
#include <array>

#include "claims/reading/claims_reader.hpp"

namespace slipproof::claims_reader {

namespace {

constexpr std::array<std::string_view, 12> claim_keys{"id",   "equation", "line",     "statement", "kind",    "setting",
                                                      "note", "grade",    "repaired", "why",       "part_of", "origin"};

class ClaimsReader {
 public:
  explicit ClaimsReader(Context& context) : context_(context) {
    for (const Setting& setting : context.file.settings) settings_.push_back(setting.id);
  }

  void read(const TomlValue& value) {
    std::vector<std::string_view> keys(claim_keys.begin(), claim_keys.end());
    keys.insert(keys.end(), body_keys_.begin(), body_keys_.end());
    const TableReader table(value, "[[claim]]", keys, context_.mistakes);
    Claim claim;
    // Stands in for an unknown kind, so that claims that refer to this one cause no further mistakes.
    claim.printed.kind = claim_kinds().front();
    read_id(table, claim);
    claim.equation = context_.optional_text(table, "equation");
    claim.line = context_.line(table, "line", true);
    claim.statement = context_.text(table, "statement", "what the paper says");
    claim.note = context_.optional_text(table, "note");
    claim.why = context_.optional_text(table, "why");
    read_setting(table, claim);
    read_grade(table, claim);
    claim.origin = context_.origin(table, context_.file.paper.origin);
    const std::size_t index = context_.file.claims.size();
    for (const PlacedText* id : table.strings("part_of")) {
      claim.part_of.push_back(id->text());
      references_.add_part(index, *id);
    }
    if (read_kind(table, claim)) {
      check_keys(table, claim.kind(), "[[claim]]");
      require_body(table, claim.kind());
      read_body({table, context_, claim.setting, claim.printed});
      references_.add(table, index, Reading::printed, claim.kind());
      read_repaired(table, claim);
    }
    context_.file.claims.push_back(std::move(claim));
  }

  void resolve_references() const { references_.resolve(context_); }

 private:
  void read_id(const TableReader& table, Claim& claim) {
    claim.id = context_.text(table, "id", "the id of the claim, such as \"A1.1\"");
    if (table.string("id") == nullptr) return;
    // Statements about the claim are theorems named by its id and a suffix (proofs/FORMAT.md).
    constexpr std::size_t longest = 40;
    const auto alphanumeric = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    };
    const auto allowed = [&](char c) { return alphanumeric(c) || c == '.' || c == '_' || c == '-'; };
    if (claim.id.empty() || !alphanumeric(claim.id.front()) || claim.id.size() > longest ||
        !std::all_of(claim.id.begin(), claim.id.end(), allowed)) {
      table.refuse("id", "found " + in_quotes(claim.id) +
                             ", expected letters, digits and . _ -, a letter or digit first, at most 40");
    } else if (context_.file.find(claim.id) != nullptr) {
      table.refuse("id", "found " + in_quotes(claim.id) + " a second time, expected another id");
    }
  }

  void read_setting(const TableReader& table, Claim& claim) {
    const PlacedText* setting = table.string("setting");
    if (setting == nullptr) {
      if (settings_.size() > 1 && !table.has("setting")) table.require("setting", "the id of a setting");
      return;
    }
    const auto found = std::find(settings_.begin(), settings_.end(), setting->text());
    if (found == settings_.end()) {
      table.refuse("setting", unknown("setting", setting->text(), settings_));
    } else {
      claim.setting = static_cast<std::size_t>(found - settings_.begin());
    }
  }

  void read_grade(const TableReader& table, Claim& claim) {
    const PlacedText* grade = table.string("grade");
    if (grade == nullptr) return;
    std::vector<std::string_view> names;
    for (const Grade known : {Grade::misprint, Grade::gap, Grade::boundary, Grade::wrong}) {
      if (grade->text() == name(known)) claim.grade = known;
      names.push_back(name(known));
    }
    if (!claim.grade) table.refuse("grade", unknown("grade", grade->text(), names));
  }

  bool read_kind(const TableReader& table, Claim& claim) {
    if (!table.require("kind", "the kind of the claim")) return false;
    const PlacedText* kind = table.string("kind");
    if (kind == nullptr) return false;
    const ClaimKind* known = claim_kind(kind->text());
    if (known != nullptr) {
      claim.printed.kind = known;
      return true;
    }
    std::vector<std::string_view> names;
    for (const ClaimKind* one : claim_kinds()) names.push_back(one->name());
    table.refuse("kind", unknown("kind", kind->text(), names));
    return false;
  }

  void check_keys(const TableReader& table, const ClaimKind& kind, std::string_view where) {
    for (const std::string_view key : body_keys_) {
      if (!table.has(key) || key == "region" || key == "expect" || kind.has(key)) continue;
      table.refuse(
          key, "found in " + std::string(where) + " of kind " + std::string(kind.name()) + ", which does not have it");
    }
  }

  void read_repaired(const TableReader& table, Claim& claim) {
    const TomlValue* value = table.table("repaired");
    if (value == nullptr) {
      if (!table.has("repaired") && table.has("why")) table.refuse("why", "found a reason without [claim.repaired]");
      return;
    }
    const TableReader repaired(*value, "[claim.repaired]", body_keys_, context_.mistakes);
    check_keys(repaired, claim.kind(), "[claim.repaired]");
    claim.repaired = claim.printed;
    read_body({repaired, context_, claim.setting, *claim.repaired});
    references_.add(repaired, context_.file.claims.size(), Reading::repaired, claim.kind());
    const bool changes = std::any_of(body_keys_.begin(), body_keys_.end(),
                                     [&](std::string_view key) { return key != "expect" && repaired.has(key); });
    if (changes) {
      table.require("why", "the reason for the repair");
    } else {
      references_.add_only_expecting(context_.file.claims.size(), table.place("repaired"));
    }
  }

  Context& context_;
  std::vector<std::string_view> settings_;
  const std::vector<std::string_view> body_keys_ = body_keys();
  OpenReferences references_;
};

}  // namespace

void read_claims(const TableReader& root, Context& context) {
  if (!root.require("claim", "at least one table [[claim]]")) return;
  ClaimsReader reader(context);
  for (const TomlValue* claim : root.tables("claim")) reader.read(*claim);
  reader.resolve_references();
}

}  // namespace slipproof::claims_reader
