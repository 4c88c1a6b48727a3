#include "mechanics/reading/read_mechanism.hpp"

#include <algorithm>
#include <array>

#include "base/expression/parser.hpp"
#include "base/input/look_alikes.hpp"
#include "base/input/near_match.hpp"
#include "base/input/text_file.hpp"
#include "mechanics/bodies/settle.hpp"
#include "mechanics/impact/impact.hpp"
#include "mechanics/mechanism/forms.hpp"
#include "mechanics/reading/impact_law.hpp"
#include "mechanics/reading/reader.hpp"
#include "mechanics/states/places.hpp"
#include "mechanics/states/velocities.hpp"

namespace slipproof {

namespace mechanism_reader {

PlacedExpression Context::parsed(const PlacedText& text, std::string_view name, Sort sort) {
  try {
    return {parse_expression(text.text(), sort), text};
  } catch (const ExpressionError& error) {
    mistakes.add(text.at(error.column() - 1), std::string(name) + ": " + error.what());
  }
  sound = false;
  return {nullptr, text};
}

PlacedExpression Context::expression(const TomlValue& value, std::string_view name, Sort sort) {
  if (value.kind == TomlValue::Kind::string) return parsed(value.text, name, sort);
  mistakes.add(value.place, std::string(name) + ": found " + std::string(kind_name(value.kind)) +
                                ", expected an expression in a string");
  sound = false;
  return {};
}

PlacedExpression Context::expression(const TableReader& table, std::string_view key, Sort sort) {
  const TomlValue* value = table.value(key);
  return value == nullptr ? PlacedExpression{} : expression(*value, key, sort);
}

PlacedExpression Context::condition(const TomlValue& value, std::string_view name) {
  if (value.kind == TomlValue::Kind::string && value.text.text() == "real") return {make_truth(true), value.text};
  return expression(value, name, Sort::truth);
}

PlacedExpression Context::condition(const TableReader& table, std::string_view key) {
  const TomlValue* value = table.value(key);
  return value == nullptr ? PlacedExpression{make_truth(true), {}} : condition(*value, key);
}

std::string Context::text(const TableReader& table, std::string_view key) {
  const PlacedText* found = table.string(key);
  return found == nullptr ? std::string() : found->text();
}

std::string Context::required(const TableReader& table, std::string_view key, std::string_view expected) {
  if (!table.require(key, expected)) return {};
  const std::string found = text(table, key);
  if (table.string(key) != nullptr && found.empty()) {
    table.refuse(key, "found nothing, expected " + std::string(expected));
  }
  return found;
}

void Context::declare(const std::string& symbol, Place place) {
  if (!is_symbol_name(symbol)) {
    const auto odd = first_odd_character(symbol);
    mistakes.add(place, "found " + in_quotes(symbol) + (odd ? " with " + describe(*odd) : "") +
                            ", expected a symbol: a letter, then letters, digits and underscores, and no word of the "
                            "language");
  } else if (std::find(symbols_.begin(), symbols_.end(), symbol) != symbols_.end()) {
    mistakes.add(place, "found the name " + in_quotes(symbol) + " a second time, expected another");
  } else {
    symbols_.push_back(symbol);
  }
}

bool Context::declare_element(const std::string& name, Place place) {
  if (!is_symbol_name(name)) {
    std::string message =
        "name: found " + in_quotes(name) + ", expected an identifier: a letter, then letters, digits ";
    mistakes.add(place, message + "and underscores, and no word of the language");
  } else if (std::find(elements_.begin(), elements_.end(), name) != elements_.end()) {
    mistakes.add(place, "name: found " + in_quotes(name) + " a second time, expected another");
  } else {
    elements_.push_back(name);
    return true;
  }
  return false;
}

bool within(std::size_t count, std::size_t limit, std::string_view key, Place place, Mistakes& mistakes) {
  if (count <= limit) return true;
  mistakes.add(place,
               std::string(key) + ": found " + std::to_string(count) + ", expected at most " + std::to_string(limit));
  return false;
}

std::optional<ElementKind::Start> read_start(std::string_view text, std::string_view key, Place place,
                                             const ElementKind& kind, std::size_t dimension, Mistakes& mistakes) {
  using Start = ElementKind::Start;
  std::vector<Start> starts{Start::rest, Start::slides_forward, Start::slides_backward, Start::open};
  if (dimension == 3) starts.erase(starts.begin() + 2);
  std::vector<std::string_view> words;
  for (const Start start : starts) words.push_back(name(start, dimension));
  const auto refuse = [&](const std::string& why) {
    mistakes.add(place, std::string(key) + ": found " + in_quotes(text) + why);
    return std::nullopt;
  };
  const auto word = std::find(words.begin(), words.end(), text);
  if (word == words.end()) {
    if (const auto meant = near_match(text, words)) return refuse(", did you mean '" + std::string(*meant) + "'?");
    return refuse(dimension == 3 ? ", expected \"rest\", \"slides\" or \"open\""
                                 : ", expected \"rest\", \"slides+\", \"slides-\" or \"open\"");
  }
  const Start start = starts[static_cast<std::size_t>(word - words.begin())];
  if (start == Start::open && kind.law == ElementKind::Law::limited) {
    return refuse(", and a friction element does not open, expected \"rest\", \"slides+\" or \"slides-\"");
  }
  if (start == Start::open && kind.bilateral) return refuse(", and a bilateral contact does not open");
  if (ElementKind{.start = start}.slides() && kind.law == ElementKind::Law::frictionless) {
    return refuse(", and for a frictionless contact it does not matter, expected \"rest\" or \"open\"");
  }
  return start;
}

}  // namespace mechanism_reader

namespace {

using mechanism_reader::Context;

constexpr std::string_view schema = "slipproof/mechanism/1";
constexpr std::array<std::string_view, 29> mechanism_keys{
    "schema",     "dimension",   "name",     "source", "note",       "reciprocal", "parameters", "assume",
    "realisable", "definitions", "angles",   "load",   "unknowns",   "units",      "motion",     "equations",
    "energy",     "contact",     "friction", "link",   "shape",      "gravity",    "body",       "joint",
    "force",      "torque",      "state",    "impact", "restitution"};

/// 2 if it is left out; nothing, and a report, for what is none.
std::optional<std::size_t> read_dimension(const TableReader& root) {
  const TomlValue* value = root.value("dimension");
  if (value == nullptr) return 2;
  const std::string found = value->text.text();
  if (value->kind == TomlValue::Kind::number && (found == "2" || found == "3")) return found == "3" ? 3 : 2;
  root.refuse("dimension", "found " + (found.empty() ? std::string(kind_name(value->kind)) : in_quotes(found)) +
                               ", expected 2 for a mechanism in the plane, or 3 for one in space");
  return std::nullopt;
}

/// [impact]; nothing without it.
std::optional<ImpactLaw> read_impact(const TableReader& root, Mistakes& mistakes) {
  const TomlValue* value = root.value("impact") == nullptr ? nullptr : root.table("impact");
  if (value == nullptr) return std::nullopt;
  static constexpr std::array<std::string_view, 1> keys{"law"};
  const TableReader table(*value, "[impact]", keys, mistakes);
  table.require("law", expected_impact_laws);
  return read_impact_law(table);
}

/// Of the bodies that were read: the contacts' states, or the impact.
void settle(const BodyGeometry& geometry, std::optional<ImpactLaw> law, Mechanism& mechanism, Mistakes& mistakes) {
  if (!law) return settle_geometry(geometry, mechanism, mistakes);
  const Approaches approaches = settle_before_impact(geometry, mechanism, mistakes, law == ImpactLaw::newton);
  if (!mistakes.empty()) return;
  mechanism = impact_of(mechanism, *mechanism.bodies, geometry, approaches, *law, mistakes);
}

void read_root(const TableReader& root, Context& context, std::optional<BodyGeometry>& geometry) {
  Mechanism& mechanism = context.mechanism;
  const std::string found = context.required(root, "schema", "\"" + std::string(schema) + "\"");
  if (!found.empty() && found != schema) {
    root.refuse("schema", "found " + in_quotes(found) + ", expected \"" + std::string(schema) + "\"");
  }
  mechanism.name = context.required(root, "name", "the mechanism's name");
  mechanism.source = context.text(root, "source");
  mechanism.note = context.text(root, "note");
  const auto dimension = read_dimension(root);
  if (!dimension) return;  // all vectors would be mistakes
  mechanism.dimension = *dimension;
  mechanism.dimension_place = root.place("dimension");
  mechanism.reciprocal = root.boolean("reciprocal").value_or(true);
  mechanism_reader::read_symbols(root, context);
  if (root.has("body")) {
    Bodies bodies = mechanism_reader::read_bodies(root, context);
    if (mechanism.dimension == 3 && root.has("shape")) {
      root.refuse("shape", "found a drawing in a plane beside bodies in space, expected none");
    }
    mechanism_reader::read_shapes(root, context);
    mechanism_reader::check_uses(bodies, context);
    if (!context.sound || !context.mistakes.empty()) return;
    place_bodies(bodies, mechanism, context.mistakes);
    if (!context.mistakes.empty()) return;
    std::vector<GeometryFact> facts = find_velocities(bodies, mechanism, context.mistakes);
    if (!context.mistakes.empty()) return;
    geometry = derive_mechanism(bodies, mechanism, context.mistakes);
    std::ranges::move(facts, std::back_inserter(geometry->facts));
    mechanism.bodies = std::make_shared<const Bodies>(std::move(bodies));
  } else {
    if (mechanism.dimension == 3)
      root.require("body", "bodies, from which the equations of a mechanism in space follow");
    for (const std::string_view key : {"gravity", "joint", "force", "torque", "state", "impact", "restitution"}) {
      if (root.has(key))
        root.refuse(key, "found without [[body]], expected bodies beside it, or [motion] in its place");
    }
    mechanism_reader::read_elements(root, context);
    mechanism_reader::read_equations(root, context);
  }
  mechanism_reader::check_uses(context);
  mechanism_reader::check_whole(context);
}

}  // namespace

Mechanism parse_mechanism(const TomlValue& table, const std::string& file, std::optional<ImpactRequest> impact) {
  Mechanism mechanism;
  mechanism.file = file;
  Mistakes mistakes(file);
  Context context(mechanism, mistakes);
  std::optional<BodyGeometry> geometry;
  const TableReader root(table, "", mechanism_keys, mistakes);
  std::optional<ImpactLaw> law = read_impact(root, mistakes);
  if (impact) law = impact->law ? impact->law : law.value_or(ImpactLaw::moreau);
  read_root(root, context, geometry);
  derive_forms(mechanism, mistakes);
  load_bounds(mechanism, mistakes);
  if (mistakes.empty()) mechanism_reader::check_domain(context);
  if (mistakes.empty() && law && !geometry) {
    mistakes.add({}, "found a mechanism by its equations, expected bodies with velocities for an impact");
  }
  if (mistakes.empty() && geometry) settle(*geometry, law, mechanism, mistakes);
  mistakes.refuse_if_any();
  return mechanism;
}

Mechanism parse_mechanism(std::string_view text, const std::string& file, std::optional<ImpactRequest> impact) {
  Mistakes mistakes(file);
  const auto document = parse_toml(text, mistakes);
  mistakes.refuse_if_any();
  return parse_mechanism(*document, file, impact);
}

Mechanism read_mechanism(const std::filesystem::path& path, std::optional<ImpactRequest> impact) {
  return parse_mechanism(read_text_file(path), path.string(), impact);
}

}  // namespace slipproof
