#include <algorithm>
#include <array>

#include "claims/claims_reader.hpp"
#include "claims/setting_names.hpp"

namespace slipproof::claims_reader {

namespace {

/// Which keys a kind of claim has, beyond those that every claim has.
struct Shape {
  std::vector<std::string_view> required;
  std::vector<std::string_view> optional;

  bool has(std::string_view key) const {
    return std::find(required.begin(), required.end(), key) != required.end() ||
           std::find(optional.begin(), optional.end(), key) != optional.end();
  }
};

const Shape& shape(ClaimKind kind) {
  static const std::array<Shape, all_claim_kinds.size()> shapes{{
      {{"mode", "forces"}, {"region"}},                                  // interval
      {{"modes"}, {"region", "forces"}},                                 // impossible
      {{"holds"}, {"mode", "modes", "region", "forces"}},                // formula
      {{"modes"}, {"region", "forces"}},                                 // motions
      {{"claims"}, {"except", "modes", "region", "forces"}},             // unique
      {{"claims"}, {"region"}},                                          // cover
      {{"forces", "holds"}, {"region"}},                                 // equivalence
      {{"parameter", "holds"}, {"region", "from"}},                      // limit
      {{"modes"}, {"region", "forces"}},                                 // exists
      {{"equations"}, {"given", "assume", "claims", "mode", "region"}},  // consequence
      {{"equations"}, {"given", "assume", "claims", "mode", "region"}},  // system
  }};
  return shapes[static_cast<std::size_t>(kind)];
}

constexpr std::array<std::string_view, 13> body_keys{"mode",   "modes",     "region", "forces", "holds",
                                                     "claims", "except",    "expect", "given",  "equations",
                                                     "assume", "parameter", "from"};
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

// `stick/slip+`, or with `*` for any state.
std::vector<ContactMode> expand(std::string_view pattern) {
  const auto fits = [](std::string_view part, ContactState state) { return part == "*" || part == name(state); };
  const std::size_t slash = pattern.find('/');
  std::vector<ContactMode> modes;
  if (slash == pattern.npos) return modes;
  for (const ContactMode mode : all_modes()) {
    if (fits(pattern.substr(0, slash), mode.rear) && fits(pattern.substr(slash + 1), mode.front)) modes.push_back(mode);
  }
  return modes;
}

// The references of a body, by their texts: ids are known only when all claims are read.
struct References {
  std::size_t claim;
  Reading reading;
  std::string_view key;  ///< `claims`, `except` or `given`
  std::vector<const PlacedText*> ids;
};

class ClaimsReader {
 public:
  explicit ClaimsReader(Context& context) : context_(context) {
    for (const Setting& setting : context.file.settings) settings_.push_back(setting.id);
  }

  void read(const TomlValue& value) {
    std::vector<std::string_view> keys(claim_keys.begin(), claim_keys.end());
    keys.insert(keys.end(), body_keys.begin(), body_keys.end());
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
    const bool known = read_kind(table, claim);
    if (known) {
      check_keys(table, claim.kind, "[[claim]]");
      for (const std::string_view key : shape(claim.kind).required) table.require(key, expected_value(key));
      claim.printed.region = claim.printed.forces = claim.printed.holds = make_truth(true);
      read_body(table, claim, Reading::printed, claim.printed);
      read_repaired(table, claim);
    }
    context_.file.claims.push_back(std::move(claim));
  }

  void resolve_references() {
    for (const References& references : references_) {
      Claim& claim = context_.file.claims[references.claim];
      ClaimBody& body = references.reading == Reading::printed ? claim.printed : *claim.repaired;
      for (const PlacedText* id : references.ids) resolve(claim, *id, references.key, body);
    }
    for (Claim& claim : context_.file.claims) {  // a repair that names no claims is about those of the print
      if (!claim.repaired) continue;
      if (claim.repaired->claims.empty()) claim.repaired->claims = claim.printed.claims;
      if (claim.repaired->except.empty()) claim.repaired->except = claim.printed.except;
      if (claim.repaired->given.empty()) claim.repaired->given = claim.printed.given;
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
    const auto allowed = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
             c == '-';
    };
    if (claim.id.empty() || !std::all_of(claim.id.begin(), claim.id.end(), allowed)) {
      table.refuse("id", "found " + in_quotes(claim.id) + ", expected letters, digits and . _ -");
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
    std::vector<std::string_view> names;
    for (const ClaimKind known : all_claim_kinds) {
      claim.kind = known;
      if (kind->text() == name(known)) return true;
      names.push_back(name(known));
    }
    table.refuse("kind", unknown("kind", kind->text(), names));
    return false;
  }

  void check_keys(const TableReader& table, ClaimKind kind, std::string_view where) {
    for (const std::string_view key : body_keys) {
      if (key == "expect" || !table.has(key) || shape(kind).has(key)) continue;
      table.refuse(
          key, "found in " + std::string(where) + " of kind " + std::string(name(kind)) + ", which does not have it");
    }
  }

  // Reads over what `body` already holds.
  void read_body(const TableReader& table, const Claim& claim, Reading reading, ClaimBody& body) {
    const std::size_t setting = claim.setting;
    const auto has = [&](std::string_view key) { return table.has(key) && shape(claim.kind).has(key); };
    if (has("mode")) read_mode(table, body);
    if (has_equations(claim.kind) && has("mode") && !body.modes.empty() && !body.modes.front().on_road()) {
      table.refuse("mode", "expected a mode with both wheels on the road");
    }
    if (has("modes")) read_modes(table, body);
    if (has("region")) {
      body.region = context_.expression(table, "region", Sort::truth, setting, {.definitions = true});
    }
    if (has("forces")) {
      body.forces = context_.expression(table, "forces", Sort::truth, setting, {.definitions = true, .force = true});
    }
    if (has("holds")) {
      const Allowed allowed{.definitions = true, .force = true, .quantities = !body.modes.empty()};
      body.holds = context_.expression(table, "holds", Sort::truth, setting, allowed);
    }
    const std::size_t index = context_.file.claims.size();
    for (const std::string_view key : {"claims", "except", "given"}) {
      if (has(key)) references_.push_back({index, reading, key, table.strings(key)});
    }
    if (has("equations")) read_equations(table, "equations", setting, body.equations);
    if (has("assume")) read_equations(table, "assume", setting, body.assume);
    if (has("parameter")) read_parameter(table, setting, body);
    if (has("from")) {
      body.from = context_.expression(table, "from", Sort::number, setting, {.definitions = true});
      auto& uses = context_.uses;
      if (!uses.empty() && uses.back().expression == body.from) uses.back().independent_of = body.parameter;
    }
    read_expectation(table, body);
  }

  void read_equations(const TableReader& table, std::string_view key, std::size_t setting,
                      std::vector<Expression>& equations) {
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

  void read_parameter(const TableReader& table, std::size_t setting, ClaimBody& body) {
    const PlacedText* text = table.string("parameter");
    if (text == nullptr || setting >= context_.file.settings.size()) return;
    std::vector<std::string_view> known;
    for (const Parameter& parameter : context_.file.settings[setting].parameters) known.push_back(parameter.symbol);
    body.parameter = text->text();
    if (std::find(known.begin(), known.end(), body.parameter) == known.end()) {
      table.refuse("parameter", unknown("parameter", body.parameter, known));
    }
  }

  void read_mode(const TableReader& table, ClaimBody& body) {
    const PlacedText* text = table.string("mode");
    if (text == nullptr) return;
    body.modes.clear();
    if (const auto mode = parse_mode(text->text())) {
      body.modes.push_back(*mode);
    } else {
      table.refuse("mode",
                   "found " + in_quotes(text->text()) + ", expected REAR/FRONT, each one of stick, slip+, slip-, lift");
    }
  }

  void read_modes(const TableReader& table, ClaimBody& body) {
    body.modes.clear();
    for (const PlacedText* text : table.strings("modes")) {
      const auto modes = expand(text->text());
      if (modes.empty()) {
        context_.refuse(*text, 0, "modes",
                        "found " + in_quotes(text->text()) +
                            ", expected REAR/FRONT, each one of stick, slip+, slip-, lift, or * for any");
      }
      for (const ContactMode mode : modes) {
        if (std::find(body.modes.begin(), body.modes.end(), mode) == body.modes.end()) body.modes.push_back(mode);
      }
    }
  }

  void read_expectation(const TableReader& table, ClaimBody& body) {
    body.expect = Expectation::none;
    const PlacedText* expect = table.string("expect");
    if (expect == nullptr) return;
    std::vector<std::string_view> names;
    for (const Expectation known : {Expectation::holds, Expectation::refuted, Expectation::undecided}) {
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
    const TableReader repaired(*value, "[claim.repaired]", body_keys, context_.mistakes);
    check_keys(repaired, claim.kind, "[claim.repaired]");
    claim.repaired = claim.printed;
    read_body(repaired, claim, Reading::repaired, *claim.repaired);
    const bool changes = std::any_of(body_keys.begin(), body_keys.end(),
                                     [&](std::string_view key) { return key != "expect" && repaired.has(key); });
    if (changes) {
      table.require("why", "the reason for the repair");
    } else {
      only_expecting_.push_back({context_.file.claims.size(), table.place("repaired")});
    }
  }

  static bool has_equations(ClaimKind kind) { return kind == ClaimKind::consequence || kind == ClaimKind::system; }

  void resolve(const Claim& claim, const PlacedText& id, std::string_view key, ClaimBody& body) {
    const auto& claims = context_.file.claims;
    const Claim* found = context_.file.find(id.text());
    if (found == nullptr) {
      std::vector<std::string_view> ids;
      for (const Claim& other : claims) ids.push_back(other.id);
      return context_.refuse(id, 0, key, unknown("claim", id.text(), ids));
    }
    const bool equations = has_equations(claim.kind), except = key == "except";
    const bool fits = equations ? has_equations(found->kind)
                      : except  ? found->kind == ClaimKind::motions
                                : found->kind == ClaimKind::interval || found->kind == ClaimKind::impossible;
    if (!fits || found->setting != claim.setting) {
      return context_.refuse(id, 0, key,
                             "found " + in_quotes(id.text()) + ", expected a claim of kind " +
                                 (equations ? "consequence or system"
                                  : except  ? "motions"
                                            : "interval or impossible") +
                                 " in the same setting");
    }
    std::vector<std::size_t>& list = except ? body.except : key == "given" ? body.given : body.claims;
    list.push_back(static_cast<std::size_t>(found - claims.data()));
  }

  // A claim has a repaired reading, too, if a definition or another claim that it builds on has one.
  void add_implied_readings() {
    auto& claims = context_.file.claims;
    std::vector<SettingNames> names;
    for (const Setting& setting : context_.file.settings) names.emplace_back(setting);
    const auto builds_on_repair = [&](const Claim& claim) {
      const ClaimBody& body = claim.printed;
      for (const Expression& expression : {body.region, body.forces, body.holds}) {
        if (expression && !names.empty() && names[claim.setting].readings_differ(expression)) return true;
      }
      for (const Expression& equation : body.equations) {
        if (!names.empty() && names[claim.setting].readings_differ(equation)) return true;
      }
      for (const Expression& equation : body.assume) {
        if (!names.empty() && names[claim.setting].readings_differ(equation)) return true;
      }
      const auto repaired = [&](std::size_t i) { return claims[i].repaired.has_value(); };
      return std::any_of(body.claims.begin(), body.claims.end(), repaired) ||
             std::any_of(body.given.begin(), body.given.end(), repaired) ||
             std::any_of(body.except.begin(), body.except.end(), repaired);
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
  std::vector<References> references_;
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
