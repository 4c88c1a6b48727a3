// Reads what a claim says: each key that several kinds of claims have is read in one way.
#include <algorithm>
#include <array>

#include "claims/reading/claims_reader.hpp"
#include "mechanics/mechanism/words.hpp"

namespace slipproof::claims_reader {

namespace {

/// The modes that a text stands for; if it is not a mode of the setting's mechanism, reports that and returns none.
Modes modes_in(const BodyTable& in, const PlacedText& text, std::string_view key) {
  if (in.in_setting() == nullptr) return {};
  const auto kinds = in.in_setting()->all_kinds();
  const auto pattern = parse_mode(*in.in_setting()->mechanism, kinds, text, key, in.context.mistakes);
  return pattern ? modes_of(*pattern, kinds) : Modes{};
}

void refuse_empty(const BodyTable& in, std::string_view key, const std::string& expected) {
  if (in.table.strings(key).empty()) in.table.refuse(key, "found an empty array, expected " + expected);
}

void read_mode(const BodyTable& in, std::string_view key) {
  Modes& one = in.body.modes;
  one.clear();
  const PlacedText* text = in.table.string(key);
  if (text == nullptr) return;
  Modes modes = modes_in(in, *text, key);
  if (modes.size() > 1) in.table.refuse(key, "found " + in_quotes(text->text()) + ", expected one mode, without *");
  if (modes.empty()) return;
  one = {std::move(modes.front())};
  if (in.body.kind->is_linear() && std::find(one[0].begin(), one[0].end(), ElementState::lift) != one[0].end()) {
    in.table.refuse(key, "expected a mode in which no contact lifts");
  } else if (in.body.kind->is_linear() && !has_mode(in.in_setting()->kinds(), one[0])) {
    in.table.refuse(key, "expected a mode in which no contact slips from rest in space: its direction is not known");
  }
}

void read_modes(const BodyTable& in, std::string_view key) {
  Modes& all = in.body.modes;
  all.clear();
  refuse_empty(in, key, "at least one mode");
  for (const PlacedText* text : in.table.strings(key)) {
    for (MechanismMode& mode : modes_in(in, *text, key)) {
      if (std::find(all.begin(), all.end(), mode) == all.end()) all.push_back(std::move(mode));
    }
  }
}

void read_forces(const BodyTable& in, std::string_view key) {
  in.body.forces = in.read(key, Sort::truth, {.definitions = true, .force = true});
}

void read_holds(const BodyTable& in, std::string_view key) {
  const bool force = !in.body.kind->has("parameter");  // a limit is about bicycles, not forces
  in.body.holds =
      in.read(key, Sort::truth, {.definitions = true, .force = force, .quantities = !in.body.modes.empty()});
}

void read_equations(const BodyTable& in, std::string_view key) {
  Equations& equations = key == "assume" ? in.body.assume : in.body.equations;
  equations.clear();
  const Allowed allowed{.definitions = true, .force = true, .unknowns = true};
  for (const PlacedText* text : in.table.strings(key)) {
    Expression equation = in.context.expression(*text, key, Sort::truth, in.setting, allowed);
    if (equation->operation == Operation::compare && equation->relations == std::vector{Relation::equal}) {
      equations.push_back(std::move(equation));
    } else if (equation->operation != Operation::truth) {
      in.context.refuse(*text, 0, key, "expected EXPRESSION = EXPRESSION");
    }
  }
  if (key == "equations") refuse_empty(in, key, "at least one equation");
}

/// Keeps the ids, which are resolved when all claims are read.
void read_ids(const BodyTable& in, std::string_view key) {
  if (in.body.kind->field(key)->not_empty) refuse_empty(in, key, "at least one claim");
}

void read_expectation(const BodyTable& in) {
  in.body.expect = Expectation::none;
  const PlacedText* expect = in.table.string("expect");
  if (expect == nullptr) return;
  std::vector<std::string_view> names;
  for (const Expectation known :
       {Expectation::holds, Expectation::refuted, Expectation::undecided, Expectation::vacuous}) {
    if (expect->text() == name(known)) in.body.expect = known;
    names.push_back(name(known));
  }
  if (in.body.expect == Expectation::none) in.table.refuse("expect", unknown("verdict", expect->text(), names));
}

constexpr std::string_view an_array_of_ids = "an array of ids of claims",
                           an_array_of_equations = "an array of equations";
struct SharedKey {
  std::string_view key, expected;
  decltype(ClaimField::read) read;
};
constexpr std::array<SharedKey, 9> shared_keys{{{"mode", "a contact mode such as \"stick/slip+\"", read_mode},
                                                {"modes", "an array of contact modes such as [\"*/lift\"]", read_modes},
                                                {"forces", "a condition on the force", read_forces},
                                                {"holds", "what is claimed, as a condition", read_holds},
                                                {"equations", an_array_of_equations, read_equations},
                                                {"assume", an_array_of_equations, read_equations},
                                                {"claims", an_array_of_ids, read_ids},
                                                {"except", an_array_of_ids, read_ids},
                                                {"given", an_array_of_ids, read_ids}}};

/// What a field says about its key; for a key that kinds share, what the list does.
SharedKey key_of(const ClaimField& field) {
  if (field.read != nullptr) return {field.key, field.expected, field.read};
  return *std::find_if(shared_keys.begin(), shared_keys.end(),
                       [&](const SharedKey& known) { return known.key == field.key; });
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
    if (field.need == ClaimField::Need::required) table.require(field.key, std::string(key_of(field).expected));
  }
}

void read_body(const BodyTable& in) {
  if (in.table.has("region")) in.body.region = in.read("region", Sort::truth, {.definitions = true});
  for (const ClaimField& field : in.body.kind->traits().fields) {
    if (in.table.has(field.key)) key_of(field).read(in, field.key);
  }
  read_expectation(in);
}

}  // namespace slipproof::claims_reader
