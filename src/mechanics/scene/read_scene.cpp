#include <algorithm>
#include <array>
#include <utility>

#include "base/input/table_reader.hpp"
#include "base/input/text_file.hpp"
#include "base/number/format.hpp"
#include "mechanics/mechanism/forms.hpp"
#include "mechanics/mechanism/names.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/reading/reader.hpp"
#include "mechanics/reading/shipped.hpp"
#include "mechanics/scene/bicycle_scene.hpp"
#include "mechanics/scene/read_again.hpp"
#include "mechanics/scene/read_angle.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

namespace {

using Circle = MechanismValues::Circle;

class MechanismSceneReader {
 public:
  MechanismSceneReader(const TomlValue& root, const std::string& file, std::optional<ImpactRequest> impact,
                       Mistakes& mistakes)
      : root_(root, "", keys, mistakes), file_(file), impact_(impact), mistakes_(mistakes) {}
  MechanismSceneReader(const TomlValue& root, const std::string& file, const Mechanism& known, Mistakes& mistakes)
      : root_(root, "", keys, mistakes), file_(file), mistakes_(mistakes), known_(&known) {}

  MechanismScene read() {
    scene_.name = std::filesystem::path(file_).stem().string();
    if (const PlacedText* name = root_.string("name")) scene_.name = name->text();
    std::optional<Mechanism> mechanism = known_ != nullptr ? std::optional(*known_) : read_own_or_named();
    if (!mechanism) return {};
    if (const PlacedText* question = root_.string("question")) scene_.question = question->text();
    if (const PlacedText* asked = root_.string("asked")) scene_.asked = asked->text();
    scene_.mechanism = std::move(*mechanism);
    scene_.values = default_values(scene_.mechanism);
    if (const TomlValue* state = root_.table("state")) {
      read_states(*state, scene_.mechanism, scene_.values.starts, mistakes_);
    }
    const bool in_numbers = scene_.mechanism.parameters.empty() && scene_.mechanism.angles.empty();
    if ((in_numbers && !root_.has("values")) || root_.require("values", "the table [values]")) {
      if (const TomlValue* values = root_.table("values")) read_values(*values);
    }
    if (const TomlValue* threshold = root_.table("threshold")) read_threshold(*threshold);
    return std::move(scene_);
  }

 private:
  static constexpr std::array<std::string_view, 8> keys{"name",     "mechanism", "along", "values",
                                                        "question", "asked",     "state", "threshold"};

  void read_threshold(const TomlValue& value) {
    static constexpr std::array<std::string_view, 3> threshold_keys{"parameter", "from", "to"};
    const TableReader table(value, "[threshold]", threshold_keys, mistakes_);
    table.require("parameter", "the parameter, or the load, along which the motion changes");
    table.require("from", "the value at which it is looked for first");
    table.require("to", "the value up to which it is looked for");
    const PlacedText* parameter = table.string("parameter");
    const auto from = table.number("from"), to = table.number("to");
    if (parameter != nullptr) {
      std::vector<std::string_view> names;
      for (const MechanismParameter& one : scene_.mechanism.parameters) names.push_back(one.symbol);
      if (scene_.mechanism.load) names.push_back(scene_.mechanism.load->symbol);
      if (std::ranges::find(names, parameter->text()) == names.end()) {
        table.refuse("parameter", unknown_name("parameter", parameter->text(), names));
      }
    }
    if (from && to && *from >= *to) table.refuse("to", "found " + exact_text(*to) + ", expected more than `from`");
    if (parameter != nullptr && from && to) scene_.threshold = SceneThreshold{parameter->text(), *from, *to};
  }

  std::optional<Mechanism> read_own_or_named() {
    const TomlValue* value = root_.value("mechanism");
    if (value != nullptr && value->kind == TomlValue::Kind::table) return own_mechanism(*value);
    return named_mechanism(root_, std::filesystem::path(file_).parent_path().string(), {Dimensions::any, impact_});
  }

  /// A mechanism that stands in the scene itself: the table [mechanism].
  std::optional<Mechanism> own_mechanism(const TomlValue& table) {
    try {
      Mechanism mechanism = parse_mechanism(table, file_, impact_);
      const PlacedText* along = root_.string("along");
      return along == nullptr ? std::move(mechanism) : with_load(mechanism, along->text());
    } catch (const InputError& error) {
      for (const Diagnostic& d : error.diagnostics()) {
        mistakes_.add(d.line == 0 ? root_.place("along") : Place{d.line, d.column}, d.message);
      }
    }
    return std::nullopt;
  }

  void read_values(const TomlValue& values) {
    const Mechanism& mechanism = scene_.mechanism;
    const std::vector<std::string_view> names = value_names(mechanism);
    if (!mechanism_reader::within(values.entries.size(), 4 * mechanism_reader::max_symbols, "values", values.place,
                                  mistakes_)) {
      return;
    }
    for (const TomlEntry& entry : values.entries) {
      if (std::find(names.begin(), names.end(), entry.key) != names.end()) continue;
      mistakes_.add(entry.place, "values: " + unknown_name("parameter", entry.key, names));
    }
    const TableReader table(values, "[values]", names_of(values), mistakes_);  // what is unknown is told already
    for (std::size_t i = 0; i < mechanism.parameters.size(); ++i) read_parameter(table, i);
    for (std::size_t i = 0; i < mechanism.angles.size(); ++i) read_angle(table, i);
    if (mechanism.load) scene_.load = table.number(mechanism.load->symbol);
    if (complete_) judge(table, values);
  }

  static std::vector<std::string_view> names_of(const TomlValue& table) {
    std::vector<std::string_view> names;
    for (const TomlEntry& entry : table.entries) names.push_back(entry.key);
    return names;
  }

  void read_parameter(const TableReader& table, std::size_t index) {
    const MechanismParameter& parameter = scene_.mechanism.parameters[index];
    const bool given = table.has(parameter.symbol);
    if (!given && !parameter.optional) {
      std::string expected = parameter.meaning.empty() ? "a number" : parameter.meaning;
      if (!parameter.unit.empty() && parameter.unit != "1") expected += " in " + parameter.unit;
      table.require(parameter.symbol, expected);
    }
    const auto value = table.number(parameter.symbol);
    scene_.values.given[index] = given;
    scene_.values.parameters[index] = value.value_or(0);
    complete_ = complete_ && (value || (!given && parameter.optional));
  }

  void read_angle(const TableReader& table, std::size_t index) {
    const MechanismAngle& angle = scene_.mechanism.angles[index];
    table.require(angle.name, "an angle such as { tan = \"3/4\" }");
    const TomlValue* value = table.value(angle.name);
    std::optional<Circle> point;
    if (value != nullptr) point = slipproof::read_angle(*value, angle.name, mistakes_, scene_.notes);
    complete_ = complete_ && point;
    if (point) scene_.values.angles[index] = *point;
  }

  /// Domains, assumptions, and whether there is a problem at all.
  void judge(const TableReader& table, const TomlValue& values) {
    using What = ProblemMaker::Broken::What;
    const ProblemMaker maker(scene_.mechanism);
    const auto broken = maker.broken(scene_.values);
    for (const ProblemMaker::Broken& one : broken) {
      const std::string condition = to_string(one.condition->expression);
      if (one.what == What::parameter) {
        const std::string& symbol = scene_.mechanism.parameters[one.index].symbol;
        table.refuse(symbol,
                     "found " + in_quotes(exact_text(scene_.values.parameters[one.index])) + ", expected " + condition);
      } else if (one.what == What::angle) {
        const Circle& point = scene_.values.angles[one.index];
        table.refuse(scene_.mechanism.angles[one.index].name,
                     "found an angle with the cosine " + decimal_text(point.cosine, 6) + " and the sine " +
                         decimal_text(point.sine, 6) + ", expected " + condition);
      } else {
        mistakes_.add(values.place,
                      "values: they break " + scene_.mechanism.assume[one.index].name + ", expected " + condition);
      }
    }
    if (!broken.empty()) return;
    if (scene_.load && !maker.load_domain(scene_.values).contains(*scene_.load)) {
      table.refuse(scene_.mechanism.load->symbol, "found " + in_quotes(exact_text(*scene_.load)) +
                                                      ", expected a value in " +
                                                      to_string(maker.load_domain(scene_.values)));
    }
    try {
      maker.problem(scene_.values);
    } catch (const NoValue& error) {
      mistakes_.add(values.place, std::string("values: ") + error.what());
    } catch (const InputError&) {
      return;  // too many elements for motions: what takes more finds what has no value
    }
  }

  TableReader root_;
  std::string file_;
  std::optional<ImpactRequest> impact_;
  Mistakes& mistakes_;
  const Mechanism* known_ = nullptr;  ///< read before
  MechanismScene scene_;
  bool complete_ = true;  ///< every parameter and angle has a value
};

bool is_mechanism(const TomlValue& document) {
  const TomlEntry* schema = document.find("schema");
  return schema != nullptr && schema->value.kind == TomlValue::Kind::string &&
         schema->value.text.text() == "slipproof/mechanism/1";
}

/// A mechanism all of which stands in numbers is a scene of its own.
MechanismScene scene_in_numbers(std::string_view text, const std::string& file, std::optional<ImpactRequest> impact,
                                Mistakes& mistakes) {
  MechanismScene scene;
  scene.mechanism = parse_mechanism(text, file, impact);
  if (const Mechanism& m = scene.mechanism; !m.parameters.empty() || !m.angles.empty()) {
    mistakes.add({}, "found a mechanism with " + std::string(m.parameters.empty() ? "angles" : "parameters") +
                         ", expected a scene of it, with their values: mechanism = " +
                         toml_string(std::filesystem::path(file).filename().string()) + " and [values]");
  }
  scene.name = scene.mechanism.name;
  scene.values = default_values(scene.mechanism);
  return scene;
}

bool is_xml(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != text.npos && text[first] == '<';
}

/// Whether a scene is written for any mechanism, even if it forgets to say for which.
bool names_mechanism(const TomlValue& document) {
  return document.find("mechanism") != nullptr || document.find("values") != nullptr;
}

}  // namespace

std::optional<Mechanism> named_mechanism(const TableReader& table, const std::string& directory,
                                         MechanismRequest request) {
  if (!table.require("mechanism", "the file of a mechanism, or the name of a shipped one")) return std::nullopt;
  const PlacedText* file = table.string("mechanism");
  const PlacedText* along = table.string("along");
  if (file == nullptr) return std::nullopt;
  std::string_view key = "mechanism";
  try {
    Mechanism mechanism = open_mechanism(file->text(), directory, request);
    key = "along";
    return along == nullptr ? std::move(mechanism) : with_load(mechanism, along->text());
  } catch (const InputError& error) {
    for (Diagnostic diagnostic : error.diagnostics()) {
      if (diagnostic.line == 0 && key == "along") diagnostic.file.clear();
      table.refuse(key, to_string(diagnostic));
    }
  }
  return std::nullopt;
}

void read_states(const TomlValue& table, const Mechanism& mechanism, std::vector<ElementKind::Start>& starts,
                 Mistakes& mistakes) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < mechanism.elements(); ++i) names.push_back(element_name(mechanism, i));
  const auto kinds = element_kinds(mechanism);
  for (const TomlEntry& entry : table.entries) {
    const auto found = std::find(names.begin(), names.end(), entry.key);
    if (found == names.end()) {
      mistakes.add(entry.place, "state: " + unknown_name("contact or friction element", entry.key, names));
    } else if (entry.value.kind != TomlValue::Kind::string) {
      mistakes.add(entry.value.place, entry.key + ": found " + std::string(kind_name(entry.value.kind)) +
                                          ", expected a state such as \"rest\"");
    } else {
      const auto i = static_cast<std::size_t>(found - names.begin());
      const auto start = mechanism_reader::read_start(entry.value.text.text(), entry.key, entry.value.place, kinds[i],
                                                      mechanism.dimension, mistakes);
      if (start && mechanism.impact) continue;  // before it, which its velocities say
      if (start && mechanism.bodies && *start != starts[i]) {
        mistakes.add(entry.value.place, entry.key + ": found " + in_quotes(name(*start, mechanism.dimension)) +
                                            ", but the velocities of the bodies say " +
                                            in_quotes(name(starts[i], mechanism.dimension)));
      }
      starts[i] = start.value_or(starts[i]);
    }
  }
}

MechanismScene parse_scene(std::string_view text, const std::string& file, MechanismRequest request) {
  Mistakes mistakes(file);
  MechanismScene scene;
  if (is_xml(text)) {
    mistakes.add({1, 1}, "found XML, expected a scene in TOML: `slipproof import` makes one of URDF, SDF and MJCF");
  } else if (const auto document = parse_toml(text, mistakes)) {
    scene = is_mechanism(*document)      ? scene_in_numbers(text, file, request.impact, mistakes)
            : names_mechanism(*document) ? MechanismSceneReader(*document, file, request.impact, mistakes).read()
                                         : read_bicycle_scene(*document, file, mistakes);
  }
  mistakes.refuse_if_any();
  if (request.impact && !scene.mechanism.impact)
    mistakes.add({}, "found a scene of the bicycle, expected bodies with velocities for an impact");
  mistakes.refuse_if_any();
  refuse_other(scene.mechanism, request.dimensions);
  return scene;
}

MechanismScene parse_scene_of(const Mechanism& mechanism, std::string_view text, const std::string& file) {
  Mistakes mistakes(file);
  MechanismScene scene;
  if (const auto document = parse_toml(text, mistakes))
    scene = MechanismSceneReader(*document, file, mechanism, mistakes).read();
  mistakes.refuse_if_any();
  return scene;
}

MechanismScene read_scene(const std::filesystem::path& path, MechanismRequest request) {
  return parse_scene(read_text_file(path), path.string(), request);
}

bool is_mechanism_scene(std::string_view text) {
  Mistakes mistakes("");
  const auto document = parse_toml(text, mistakes);
  return document && document->find("mechanism") != nullptr;
}

}  // namespace slipproof
