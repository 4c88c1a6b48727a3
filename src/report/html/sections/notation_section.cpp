#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/scene/bicycle_scene.hpp"
#include "report/html/sections.hpp"
#include "report/markup/mathml.hpp"
#include "report/markup/symbol.hpp"

namespace slipproof {

namespace {

struct Entry {
  std::string_view symbol, meaning, unit;
};

/// The symbols of the figure, and of the equations with counterexamples.
constexpr std::array<Entry, 28> model{{
    {"M", "total mass", "kg"},
    {"R", "radius of both wheels", "m"},
    {"h0", "height of the centre of mass C above the road", "m"},
    {"h", "height of C above the axles, h0 − R", "m"},
    {"b2", "distance of C from the rear contact, along the road", "m"},
    {"b3", "distance of C from the front contact, along the road", "m"},
    {"I1", "moment of inertia of the sprocket with the pedals", "kg m²"},
    {"I2", "moment of inertia of the rear wheel", "kg m²"},
    {"I3", "moment of inertia of the front wheel", "kg m²"},
    {"r1", "radius of the sprocket with the pedals", "m"},
    {"r2", "radius of the sprocket on the rear wheel", "m"},
    {"mu", "gear ratio, r2/r1", ""},
    {"L", "arm of the pedal below the line of the axles", "m"},
    {"sigma", "μ L/R: the force at the road for each unit of pedal force", ""},
    {"J", "pitch inertia of the frame about C, with wheels and sprocket as point masses at their hinges", "kg m²"},
    {"f", "Coulomb coefficient of the road", ""},
    {"g", "gravity", "m/s²"},
    {"F", "pedal force, backwards when positive; internal: from the rider, external: from beside the bicycle", "N"},
    {"a", "acceleration of C forwards", "m/s²"},
    {"a_y", "acceleration of C downwards", "m/s²"},
    {"phi", "angular acceleration of the frame, clockwise", "1/s²"},
    {"eps1", "angular acceleration of the sprocket", "1/s²"},
    {"eps2", "angular acceleration of the rear wheel; eps3: of the front wheel", "1/s²"},
    {"T", "difference of the tensions of the chain's two runs", "N"},
    {"S2", "tangential reaction of the road at the rear wheel, forwards; S3: at the front wheel", "N"},
    {"N2", "normal reaction of the road at the rear wheel, upwards; N3: at the front wheel", "N"},
    {"gap2", "acceleration with which the rear wheel leaves the road; gap3: the front wheel", "m/s²"},
    {"slip2", "tangential acceleration of the rear contact, forwards; slip3: of the front contact", "m/s²"},
}};

ReportTable symbols_table(std::string caption, const char* last_column) {
  ReportTable table{{"symbol", "meaning", last_column}};
  table.label = table.caption = std::move(caption);
  table.css_class = "notation";
  return table;
}

ReportCell symbol_cell(std::string_view symbol) {
  return drawn(plain_symbol(symbol), [symbol = std::string(symbol)](const Element& parent) {
    const Element math = add_math(parent);
    math.set("aria-label", plain_symbol(symbol));  // a header needs a name, and a formula has none
    add_symbol(math, symbol);
  });
}

std::string load_meaning(const Setting& setting) {
  const MechanismLoad& load = *setting.mechanism->load;
  return load.meaning.empty() ? "the load" : load.meaning;
}

/// The symbols of a mechanism from a file, with the file's words and units.
void add_mechanism(const Element& section, const Setting& setting) {
  const Mechanism& mechanism = *setting.mechanism;
  ReportTable table = symbols_table("Symbols of the mechanism: " + mechanism.name, "unit");
  const auto add = [&](const std::string& symbol, const std::string& meaning, const std::string& unit) {
    table.row({symbol_cell(symbol), meaning, unit == "1" ? "" : unit});
  };
  for (const MechanismParameter& parameter : mechanism.parameters) {
    add(parameter.symbol, parameter.meaning, parameter.unit);
  }
  for (const MechanismAngle& angle : mechanism.angles) {
    add(angle.cosine, "cosine: " + angle.meaning, "");
    add(angle.sine, "sine: " + angle.meaning, "");
  }
  if (mechanism.load) add(mechanism.load->symbol, mechanism.load->meaning, mechanism.load->unit);
  for (const MechanismUnknown& unknown : mechanism.unknowns) {
    const bool acceleration = unknown.role == MechanismUnknown::Role::acceleration;
    add(unknown.symbol, acceleration ? "acceleration" : "force", unknown.unit);
  }
  add_table(section, table);
}

void add_setting(const Element& section, const Setting& setting) {
  const std::string name = setting.statement.empty() ? setting.id : setting.id + ": " + setting.statement;
  ReportTable table = symbols_table("Symbols, " + name, "domain");
  for (const FreeParameter& parameter : setting.parameters) {
    table.row({symbol_cell(parameter.symbol), parameter.meaning, formula(parameter.domain)});
  }
  if (!setting.force.symbol.empty()) {
    table.row({symbol_cell(setting.force.symbol), load_meaning(setting), formula(setting.force.domain)});
  }
  add_table(section, table);
  if (setting.realisable.empty()) return;
  const Element p = section.add("p");
  p.text("Called buildable, in this setting, is a " + std::string(noun(setting, "mechanism")) + " with ");
  for (const Realisable& condition : setting.realisable) {
    if (&condition != &setting.realisable.front()) p.text(", ");
    add_math(p, condition.condition);
    p.text(" (" + condition.name + ")");
  }
  p.text(".");
}

/// The symbols of the bicycle and of other mechanisms, each mechanism once.
void add_models(const Element& section, const ClaimsFile& claims) {
  std::vector<std::string> told;  // by name: the same mechanism with another load is not repeated
  for (const Setting& setting : claims.settings) {
    const std::string& name = setting.mechanism->name;
    if (std::find(told.begin(), told.end(), name) != told.end()) continue;
    told.push_back(name);
    if (!is_bicycle(*setting.mechanism)) {
      add_mechanism(section, setting);
      continue;
    }
    ReportTable table = symbols_table("Symbols of the model", "unit");
    for (const Entry& entry : model) table.row({symbol_cell(entry.symbol), entry.meaning, entry.unit});
    add_table(section, table);
  }
}

}  // namespace

void add_notation_section(const Element& main, const PageInput& input) {
  const Element section = add_section(main, "notation", "Notation");
  const auto& settings = input.claims->settings;
  const bool bicycles =
      std::all_of(settings.begin(), settings.end(), [](const Setting& s) { return is_bicycle(*s.mechanism); });
  const std::string strict =
      " A motion is strict in its mode if all conditions of the mode hold strictly, and a boundary motion if one holds "
      "with equality.";
  section.add("p", "lead")
      .text(bicycles
                ? "Axes: x forwards, y down; turns count clockwise. A contact mode is written rear/front: stick, slip+ "
                  "(the contact slips forwards), slip- (backwards), lift (the wheel leaves the road)." +
                      strict
                : "A contact mode is a state of each contact, then of each friction element, in the order of the "
                  "mechanism's file, joined by /: stick, slip+ and slip- (with the sign of the slip), touch (without "
                  "friction), lift (it opens)." +
                      strict);
  add_models(section, *input.claims);
  for (const Setting& setting : settings) add_setting(section, setting);
}

}  // namespace slipproof
