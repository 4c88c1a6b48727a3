// Reads what a claim says: each key that kinds of claims have is read in one way.
#include <algorithm>
#include <array>

#include "claims/kinds/kinds.hpp"
#include "claims/reading/claims_reader.hpp"
#include "mechanics/mechanism/words.hpp"

namespace slipproof::claims_reader {

namespace {

class BodyReader {
 public:
  BodyReader(const TableReader& table, Context& context, std::size_t setting, ClaimBody& body)
      : table_(table), context_(context), setting_(setting), body_(body) {}

  void mode(std::string_view) {
    body_.modes.clear();
    const PlacedText* text = table_.string("mode");
    if (text == nullptr) return;
    Modes modes = modes_in(*text, "mode");
    if (modes.size() > 1) table_.refuse("mode", "found " + in_quotes(text->text()) + ", expected one mode, without *");
    if (modes.empty()) return;
    body_.modes = {std::move(modes.front())};
    if (body_.kind->is_linear() &&
        std::find(body_.modes[0].begin(), body_.modes[0].end(), ElementState::lift) != body_.modes[0].end()) {
      table_.refuse("mode", "expected a mode in which no contact lifts");
    }
  }

  void modes(std::string_view key) {
    body_.modes.clear();
    refuse_empty(key, "at least one mode");
    for (const PlacedText* text : table_.strings(key)) {
      for (MechanismMode& mode : modes_in(*text, key)) {
        if (std::find(body_.modes.begin(), body_.modes.end(), mode) == body_.modes.end()) {
          body_.modes.push_back(std::move(mode));
        }
      }
    }
  }

  void forces(std::string_view key) { body_.forces = read(key, Sort::truth, {.definitions = true, .force = true}); }

  void holds(std::string_view key) {
    const bool force = !body_.kind->has("parameter");  // a limit is about bicycles, not forces
    body_.holds = read(key, Sort::truth, {.definitions = true, .force = force, .quantities = !body_.modes.empty()});
  }

  void equations(std::string_view key) {
    Equations& equations = key == "assume" ? body_.assume : body_.equations;
    equations.clear();
    const Allowed allowed{.definitions = true, .force = true, .unknowns = true};
    for (const PlacedText* text : table_.strings(key)) {
      Expression equation = context_.expression(*text, key, Sort::truth, setting_, allowed);
      if (equation->operation == Operation::compare && equation->relations == std::vector{Relation::equal}) {
        equations.push_back(std::move(equation));
      } else if (equation->operation != Operation::truth) {
        context_.refuse(*text, 0, key, "expected EXPRESSION = EXPRESSION");
      }
    }
    if (key == "equations") refuse_empty(key, "at least one equation");
  }

  void parameter(std::string_view key) {
    body_.parameter.clear();
    const PlacedText* text = table_.string(key);
    if (text == nullptr || setting_ >= context_.file.settings.size()) return;
    std::vector<std::string_view> known;
    for (const Parameter& parameter : context_.file.settings[setting_].parameters) {
      if (!parameter.angle) known.push_back(parameter.symbol);
    }
    if (std::find(known.begin(), known.end(), text->text()) == known.end()) {
      table_.refuse(key, unknown("parameter", text->text(), known));
    }
    body_.parameter = text->text();
  }

  void from(std::string_view key) {
    body_.from = read(key, Sort::number, {.definitions = true});
    auto& uses = context_.uses;
    if (!uses.empty() && uses.back().expression == body_.from) uses.back().independent_of = body_.parameter;
  }

  /// Keeps the ids, which are resolved when all claims are read.
  void references(std::string_view key) {
    if (body_.kind->field(key)->not_empty) refuse_empty(key, "at least one claim");
  }

  void expectation() {
    body_.expect = Expectation::none;
    const PlacedText* expect = table_.string("expect");
    if (expect == nullptr) return;
    std::vector<std::string_view> names;
    for (const Expectation known :
         {Expectation::holds, Expectation::refuted, Expectation::undecided, Expectation::vacuous}) {
      if (expect->text() == name(known)) body_.expect = known;
      names.push_back(name(known));
    }
    if (body_.expect == Expectation::none) table_.refuse("expect", unknown("verdict", expect->text(), names));
  }

 private:
  Expression read(std::string_view key, Sort sort, Allowed allowed) {
    return context_.expression(table_, key, sort, setting_, allowed);
  }

  void refuse_empty(std::string_view key, const std::string& expected) {
    if (table_.strings(key).empty()) table_.refuse(key, "found an empty array, expected " + expected);
  }

  /// The modes that a text stands for; if it is not a mode of the setting's mechanism, reports that and returns none.
  Modes modes_in(const PlacedText& text, std::string_view key) {
    if (setting_ >= context_.file.settings.size()) return {};
    const Setting& s = context_.file.settings[setting_];
    const auto kinds = s.all_kinds();
    const auto pattern = parse_mode(*s.mechanism, kinds, text, key, context_.mistakes);
    return pattern ? modes_of(*pattern, kinds) : Modes{};
  }

  const TableReader& table_;
  Context& context_;
  std::size_t setting_;
  ClaimBody& body_;
};

struct BodyKey {
  std::string_view key, expected;
  void (BodyReader::*read)(std::string_view key);
};

constexpr std::string_view an_array_of_ids = "an array of ids of claims",
                           an_array_of_equations = "an array of equations";
constexpr std::array<BodyKey, 11> body_key_table{
    {{"mode", "a contact mode such as \"stick/slip+\"", &BodyReader::mode},
     {"modes", "an array of contact modes such as [\"*/lift\"]", &BodyReader::modes},
     {"forces", "a condition on the force", &BodyReader::forces},
     {"holds", "what is claimed, as a condition", &BodyReader::holds},
     {"equations", an_array_of_equations, &BodyReader::equations},
     {"assume", an_array_of_equations, &BodyReader::equations},
     {"parameter", "a parameter of the setting", &BodyReader::parameter},
     {"from", "a number, independent of the parameter", &BodyReader::from},
     {"claims", an_array_of_ids, &BodyReader::references},
     {"except", an_array_of_ids, &BodyReader::references},
     {"given", an_array_of_ids, &BodyReader::references}}};

const BodyKey& body_key(std::string_view key) {
  return *std::find_if(body_key_table.begin(), body_key_table.end(),
                       [&](const BodyKey& known) { return known.key == key; });
}

}  // namespace

std::vector<std::string_view> body_keys() {
  std::vector<std::string_view> keys{"region", "expect"};
  for (const ClaimKind* kind : claim_kinds()) {
    for (const ClaimField& field : kind->traits().fields) {
      if (std::find(keys.begin(), keys.end(), field.key) == keys.end()) keys.push_back(field.key);
    }
  }
  return keys;
}

void require_body(const TableReader& table, const ClaimKind& kind) {
  for (const ClaimField& field : kind.traits().fields) {
    if (field.need == ClaimField::Need::required) table.require(field.key, std::string(body_key(field.key).expected));
  }
}

void read_body(const TableReader& table, Context& context, std::size_t setting, ClaimBody& body) {
  if (table.has("region")) {
    body.region = context.expression(table, "region", Sort::truth, setting, {.definitions = true});
  }
  BodyReader reader(table, context, setting, body);
  for (const ClaimField& field : body.kind->traits().fields) {
    if (table.has(field.key)) (reader.*body_key(field.key).read)(field.key);
  }
  reader.expectation();
}

}  // namespace slipproof::claims_reader
