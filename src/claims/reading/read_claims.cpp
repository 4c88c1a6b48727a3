#include <algorithm>
#include <array>

#include "claims/reading/claims_reader.hpp"
#include "claims/reading/setting_names.hpp"
#include "mechanics/mechanism/words.hpp"

namespace slipproof::claims_reader {

namespace {

/// All keys that some kind of claim has, and those that say something of every kind.
std::vector<std::string_view> body_keys() {
  std::vector<std::string_view> keys{"region", "expect"};
  for (const std::string_view kind : kind_names()) {
    const ClaimKind one = *parse_kind(kind);
    for_each_field(one, [&](std::string_view key, const auto&, Need) {
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
    });
  }
  return keys;
}

bool has_key(const ClaimKind& kind, std::string_view key) {
  bool found = key == "region" || key == "expect";
  for_each_field(kind, [&](std::string_view own, const auto&, Need) { found = found || own == key; });
  return found;
}

constexpr std::array<std::string_view, 11> claim_keys{"id",   "equation", "line",     "statement", "kind",   "setting",
                                                      "note", "grade",    "repaired", "why",       "part_of"};

std::string expected_value(std::string_view key) {
  if (key == "mode") return "a contact mode such as \"stick/slip+\"";
  if (key == "modes") return "an array of contact modes such as [\"*/lift\"]";
  if (key == "forces") return "a condition on the force";
  if (key == "equations" || key == "assume") return "an array of equations";
  if (key == "parameter") return "a parameter of the setting";
  if (key == "holds") return "what is claimed, as a condition";
  return "an array of ids of claims";
}

// The references of a body, by their texts: ids are known only when all claims are read.
struct ReferenceTexts {
  std::size_t claim;
  Reading reading;
  std::string_view key;  ///< `claims`, `except` or `given`
  std::vector<const PlacedText*> ids;
};

/// The field with this key, which must be one of references.
References& references_of(ClaimBody& body, std::string_view key) {
  References* found = nullptr;
  for_each_field(body.says, [&](std::string_view own, auto& field, Need) {
    if constexpr (std::is_same_v<std::decay_t<decltype(field)>, References>) {
      if (own == key) found = &field;
    }
  });
  return *found;
}

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
    read_id(table, claim);
    claim.equation = context_.optional_text(table, "equation");
    claim.line = context_.line(table, "line", true);
    claim.statement = context_.text(table, "statement", "what the paper says");
    claim.note = context_.optional_text(table, "note");
    claim.why = context_.optional_text(table, "why");
    read_setting(table, claim);
    read_grade(table, claim);
    for (const PlacedText* id : table.strings("part_of")) {
      claim.part_of.push_back(id->text());
      parts_.push_back({context_.file.claims.size(), id});
    }
    if (read_kind(table, claim)) {
      check_keys(table, claim.printed.says, "[[claim]]");
      for_each_field(claim.printed.says, [&](std::string_view key, const auto&, Need need) {
        if (need == Need::required) table.require(key, expected_value(key));
      });
      read_body(table, claim, Reading::printed, claim.printed);
      read_repaired(table, claim);
    }
    context_.file.claims.push_back(std::move(claim));
  }

  void resolve_references() {
    for (const ReferenceTexts& texts : references_) {
      Claim& claim = context_.file.claims[texts.claim];
      ClaimBody& body = texts.reading == Reading::printed ? claim.printed : *claim.repaired;
      for (const PlacedText* id : texts.ids) resolve(claim, *id, texts.key, references_of(body, texts.key));
    }
    for (Claim& claim : context_.file.claims) {  // a repair that names no claims is about those of the print
      if (!claim.repaired) continue;
      for (const std::string_view key : {"claims", "except", "given"}) {
        if (!has_key(claim.printed.says, key)) continue;
        References& named = references_of(*claim.repaired, key);
        if (named.empty()) named = references_of(claim.printed, key);
      }
    }
    add_implied_readings();
    for (const auto& [claim, id] : parts_) check_part(context_.file.claims[claim], *id);
  }

 private:
  void check_part(const Claim& claim, const PlacedText& id) {
    for (const Setting& setting : context_.file.settings) {
      for (const Definition& definition : setting.definitions) {
        if (definition.repaired && slipproof::id(definition) == id.text()) return;
      }
    }
    const Claim* found = context_.file.find(id.text());
    if (found != nullptr && found != &claim && found->grade && found->part_of.empty()) return;
    context_.refuse(id, 0, "part_of",
                    "found " + in_quotes(id.text()) +
                        ", expected another claim with a grade and no part_of, or EQUATION.SYMBOL of a definition "
                        "with a repair");
  }

  void read_id(const TableReader& table, Claim& claim) {
    claim.id = context_.text(table, "id", "the id of the claim, such as \"A1.1\"");
    if (table.string("id") == nullptr) return;
    // Statements about the claim are theorems of this name and a suffix (proofs/FORMAT.md).
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
    const auto known = parse_kind(kind->text());
    if (known) {
      claim.printed.says = *known;
    } else {
      table.refuse("kind", unknown("kind", kind->text(), kind_names()));
    }
    return known.has_value();
  }

  void check_keys(const TableReader& table, const ClaimKind& kind, std::string_view where) {
    for (const std::string_view key : body_keys_) {
      if (!table.has(key) || has_key(kind, key)) continue;
      table.refuse(
          key, "found in " + std::string(where) + " of kind " + std::string(name(kind)) + ", which does not have it");
    }
  }

  // Reads over what `body` already holds.
  void read_body(const TableReader& table, const Claim& claim, Reading reading, ClaimBody& body) {
    if (table.has("region")) {
      body.region = context_.expression(table, "region", Sort::truth, claim.setting, {.definitions = true});
    }
    for_each_field(body.says, [&](std::string_view key, auto& field, Need) {
      if (!table.has(key)) return;
      using Field = std::decay_t<decltype(field)>;
      if constexpr (std::is_same_v<Field, References>) {
        references_.push_back({context_.file.claims.size(), reading, key, table.strings(key)});
        if (key == "claims" && (claim.is<Cover>() || claim.is<ForceCover>()))
          refuse_empty(table, key, "at least one claim");
      } else if constexpr (std::is_same_v<Field, Equations>) {
        read_equations(table, key, claim.setting, field);
        if (key == "equations") refuse_empty(table, key, "at least one equation");
      } else if constexpr (std::is_same_v<Field, MechanismMode>) {
        if (auto mode = read_mode(table, claim.setting)) field = std::move(*mode);
      } else if constexpr (std::is_same_v<Field, std::optional<MechanismMode>>) {
        field = read_mode(table, claim.setting);
        if (field && std::find(field->begin(), field->end(), ElementState::lift) != field->end()) {
          table.refuse("mode", "expected a mode in which no contact lifts");
        }
      } else if constexpr (std::is_same_v<Field, Modes>) {
        read_modes(table, key, claim.setting, field);
      } else if constexpr (std::is_same_v<Field, std::string>) {
        field = read_parameter(table, claim.setting);
      } else {
        field = read_expression(table, key, claim.setting, body);
      }
    });
    read_expectation(table, body);
  }

  void refuse_empty(const TableReader& table, std::string_view key, const std::string& expected) {
    if (table.strings(key).empty()) table.refuse(key, "found an empty array, expected " + expected);
  }

  Expression read_expression(const TableReader& table, std::string_view key, std::size_t setting,
                             const ClaimBody& body) {
    if (key == "forces") {
      return context_.expression(table, key, Sort::truth, setting, {.definitions = true, .force = true});
    }
    if (key == "holds") {
      const bool quantities = std::holds_alternative<Formula>(body.says) && !modes(body.says).empty();
      const bool force = !std::holds_alternative<Limit>(body.says);  // it speaks of bicycles
      return context_.expression(table, key, Sort::truth, setting,
                                 {.definitions = true, .force = force, .quantities = quantities});
    }
    Expression from = context_.expression(table, key, Sort::number, setting, {.definitions = true});
    auto& uses = context_.uses;
    if (!uses.empty() && uses.back().expression == from) {
      uses.back().independent_of = std::get<Limit>(body.says).parameter;
    }
    return from;
  }

  void read_equations(const TableReader& table, std::string_view key, std::size_t setting, Equations& equations) {
    equations.clear();
    const Allowed allowed{.definitions = true, .force = true, .unknowns = true};
    for (const PlacedText* text : table.strings(key)) {
      Expression equation = context_.expression(*text, key, Sort::truth, setting, allowed);
      if (equation->operation == Operation::compare && equation->relations == std::vector{Relation::equal}) {
        equations.push_back(std::move(equation));
      } else if (equation->operation != Operation::truth) {
        context_.refuse(*text, 0, key, "expected EXPRESSION = EXPRESSION");
      }
    }
  }

  std::string read_parameter(const TableReader& table, std::size_t setting) {
    const PlacedText* text = table.string("parameter");
    if (text == nullptr || setting >= context_.file.settings.size()) return {};
    std::vector<std::string_view> known;
    for (const Parameter& parameter : context_.file.settings[setting].parameters) {
      if (!parameter.angle) known.push_back(parameter.symbol);
    }
    if (std::find(known.begin(), known.end(), text->text()) == known.end()) {
      table.refuse("parameter", unknown("parameter", text->text(), known));
    }
    return text->text();
  }

  /// The modes that a text stands for; none, which is reported, if it is no mode of the setting's mechanism.
  Modes modes_in(const PlacedText& text, std::string_view key, std::size_t setting) {
    if (setting >= context_.file.settings.size()) return {};
    const Setting& s = context_.file.settings[setting];
    const auto kinds = s.all_kinds();
    const auto pattern = parse_mode(*s.mechanism, kinds, text, key, context_.mistakes);
    return pattern ? modes_of(*pattern, kinds) : Modes{};
  }

  std::optional<MechanismMode> read_mode(const TableReader& table, std::size_t setting) {
    const PlacedText* text = table.string("mode");
    if (text == nullptr) return std::nullopt;
    Modes modes = modes_in(*text, "mode", setting);
    if (modes.size() > 1) table.refuse("mode", "found " + in_quotes(text->text()) + ", expected one mode, without *");
    if (modes.empty()) return std::nullopt;
    return std::move(modes.front());
  }

  void read_modes(const TableReader& table, std::string_view key, std::size_t setting, Modes& found) {
    found.clear();
    if (key == "mode") {
      if (auto mode = read_mode(table, setting)) found.push_back(std::move(*mode));
      return;
    }
    refuse_empty(table, key, "at least one mode");
    for (const PlacedText* text : table.strings(key)) {
      for (MechanismMode& mode : modes_in(*text, key, setting)) {
        if (std::find(found.begin(), found.end(), mode) == found.end()) found.push_back(std::move(mode));
      }
    }
  }

  void read_expectation(const TableReader& table, ClaimBody& body) {
    body.expect = Expectation::none;
    const PlacedText* expect = table.string("expect");
    if (expect == nullptr) return;
    std::vector<std::string_view> names;
    for (const Expectation known :
         {Expectation::holds, Expectation::refuted, Expectation::undecided, Expectation::vacuous}) {
      if (expect->text() == name(known)) body.expect = known;
      names.push_back(name(known));
    }
    if (body.expect == Expectation::none) table.refuse("expect", unknown("verdict", expect->text(), names));
  }

  void read_repaired(const TableReader& table, Claim& claim) {
    const TomlValue* value = table.table("repaired");
    if (value == nullptr) {
      if (!table.has("repaired") && table.has("why")) table.refuse("why", "found a reason without [claim.repaired]");
      return;
    }
    const TableReader repaired(*value, "[claim.repaired]", body_keys_, context_.mistakes);
    check_keys(repaired, claim.printed.says, "[claim.repaired]");
    claim.repaired = claim.printed;
    read_body(repaired, claim, Reading::repaired, *claim.repaired);
    const bool changes = std::any_of(body_keys_.begin(), body_keys_.end(),
                                     [&](std::string_view key) { return key != "expect" && repaired.has(key); });
    if (changes) {
      table.require("why", "the reason for the repair");
    } else {
      only_expecting_.push_back({context_.file.claims.size(), table.place("repaired")});
    }
  }

  // Whether a claim with this key may refer to the other one, and what it has to be.
  static std::string_view misfit(const Claim& claim, std::string_view key, const Claim& other) {
    const auto has_equations = [](const Claim& c) { return c.is<Consequence>() || c.is<System>(); };
    if (has_equations(claim)) return has_equations(other) ? "" : "consequence or system";
    if (key == "except") return other.is<Motions>() ? "" : "motions";
    if (claim.is<Unique>()) return other.is<Interval>() ? "" : "interval";
    if (claim.is<ForceCover>()) return other.is<Interval>() || other.is<Motions>() ? "" : "interval or motions";
    return other.is<Interval>() || other.is<Impossible>() ? "" : "interval or impossible";
  }

  void resolve(const Claim& claim, const PlacedText& id, std::string_view key, References& list) {
    const auto& claims = context_.file.claims;
    const Claim* found = context_.file.find(id.text());
    if (found == nullptr) {
      std::vector<std::string_view> ids;
      for (const Claim& other : claims) ids.push_back(other.id);
      return context_.refuse(id, 0, key, unknown("claim", id.text(), ids));
    }
    std::string_view expected = misfit(claim, key, *found);
    if (expected.empty() && found->setting != claim.setting) expected = name(found->printed.says);
    if (!expected.empty()) {
      return context_.refuse(id, 0, key,
                             "found " + in_quotes(id.text()) + ", expected a claim of kind " + std::string(expected) +
                                 " in the same setting");
    }
    list.push_back(static_cast<std::size_t>(found - claims.data()));
  }

  // A claim has a repaired reading, too, if a definition or another claim that it builds on has one.
  void add_implied_readings() {
    auto& claims = context_.file.claims;
    std::vector<SettingNames> names;
    for (const Setting& setting : context_.file.settings) names.emplace_back(setting);
    const auto builds_on_repair = [&](const Claim& claim) {
      bool found = false;
      for_each_part(claim.printed, [&](BodyPart, std::size_t, const Expression& expression) {
        found = found || (!names.empty() && names[claim.setting].readings_differ(expression));
      });
      const References others = references(claim.printed.says);
      return found ||
             std::any_of(others.begin(), others.end(), [&](std::size_t i) { return claims[i].repaired.has_value(); });
    };
    std::vector<bool> implied(claims.size());
    for (bool more = true; more;) {  // along the references, until none gains a reading
      more = false;
      for (std::size_t i = 0; i < claims.size(); ++i) {
        implied[i] = builds_on_repair(claims[i]);
        if (!implied[i] || claims[i].repaired) continue;
        more = true;
        claims[i].repaired = claims[i].printed;
        claims[i].repaired->expect = Expectation::none;
      }
    }
    for (const auto& [claim, place] : only_expecting_) {
      if (implied[claim]) continue;
      context_.mistakes.add(place,
                            "repaired: found a reading that changes nothing, and no definition that it uses has "
                            "a repair, expected a key of the claim with another value");
    }
  }

  struct Expecting {
    std::size_t claim;
    Place place;
  };

  Context& context_;
  std::vector<std::string_view> settings_;
  const std::vector<std::string_view> body_keys_ = body_keys();
  std::vector<ReferenceTexts> references_;
  std::vector<Expecting> only_expecting_;
  std::vector<std::pair<std::size_t, const PlacedText*>> parts_;  ///< claims, and what they are part of
};

}  // namespace

void read_claims(const TableReader& root, Context& context) {
  if (!root.require("claim", "at least one table [[claim]]")) return;
  ClaimsReader reader(context);
  for (const TomlValue* claim : root.tables("claim")) reader.read(*claim);
  reader.resolve_references();
}

}  // namespace slipproof::claims_reader
