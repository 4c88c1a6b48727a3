#include "mechanics/bicycle/scene.hpp"

#include <array>
#include <initializer_list>
#include <optional>
#include <span>
#include <stdexcept>

#include "base/input/table_reader.hpp"
#include "base/input/text_file.hpp"
#include "base/input/toml.hpp"

namespace slipproof {

namespace {

enum class Domain { any, not_negative, positive };

/// What a key of a scene means; the message about a missing one says so.
struct Parameter {
  std::string_view key;
  std::string_view meaning;
  Domain domain;
};

constexpr std::array<Parameter, 21> parameters{{
    {"R", "the radius of both wheels in m", Domain::positive},
    {"h", "the height of the centre of mass above the axles in m", Domain::any},
    {"h0", "the height of the centre of mass above the road in m", Domain::positive},
    {"b", "the distance b2 = b3 of the centre of mass from each contact in m", Domain::positive},
    {"b2", "the horizontal distance of the centre of mass from the rear contact in m", Domain::any},
    {"b3", "the horizontal distance of the centre of mass from the front contact in m", Domain::any},
    {"I1", "the moment of inertia of the sprocket in kg m^2", Domain::not_negative},
    {"I2", "the moment of inertia of the rear wheel in kg m^2", Domain::not_negative},
    {"I3", "the moment of inertia of the front wheel in kg m^2", Domain::not_negative},
    {"M2", "(I1 + I2)/R^2 for M = 1", Domain::not_negative},
    {"M3", "I3/R^2 for M = 1", Domain::not_negative},
    {"r1", "the radius of the pedal sprocket in m", Domain::positive},
    {"r2", "the radius of the rear sprocket in m", Domain::positive},
    {"mu", "the gear ratio r2/r1", Domain::positive},
    {"L", "the arm of the pedal in m", Domain::any},
    {"M", "the total mass in kg", Domain::positive},
    {"J", "the pitch inertia of the frame in kg m^2", Domain::positive},
    {"f", "the coefficient of friction", Domain::not_negative},
    {"g", "gravity in m/s^2", Domain::positive},
    {"F", "the pedal force in N", Domain::any},
    {"P", "F sigma in N", Domain::any},
}};

constexpr std::array<std::string_view, 4> root_keys{"name", "bicycle", "road", "force"};
constexpr std::array<std::string_view, 17> bicycle_keys{"R",  "h",  "h0", "b",  "b2", "b3", "I1", "I2", "I3",
                                                        "M2", "M3", "r1", "r2", "mu", "L",  "M",  "J"};
constexpr std::array<std::string_view, 2> road_keys{"f", "g"};
constexpr std::array<std::string_view, 3> force_keys{"kind", "F", "P"};

/// Of two ways to say the same thing, the one that a scene uses.
enum class Form { first, second, both, none };

using Keys = std::initializer_list<std::string_view>;

std::string listed(Keys keys) {
  std::string text;
  for (const std::string_view key : keys) text += (text.empty() ? "" : ", ") + std::string(key);
  return text;
}

/// Reads the parameters of one table, judges each by its domain, and remembers nothing of those that failed.
class ParameterReader {
 public:
  ParameterReader(const TomlValue& table, const std::string& name, std::span<const std::string_view> keys,
                  Mistakes& mistakes)
      : table_(table, name, keys, mistakes) {}

  const TableReader& table() const { return table_; }
  bool has(std::string_view key) const { return table_.has(key); }

  std::optional<Rational> optional(std::string_view key) const {
    auto value = table_.number(key);
    if (!value) return value;
    const Parameter& parameter = find(key);
    const bool inside = parameter.domain == Domain::any || sign(*value) > 0 ||
                        (parameter.domain == Domain::not_negative && sign(*value) == 0);
    if (inside) return value;
    refuse(key, std::string(key) + (parameter.domain == Domain::positive ? " > 0" : " >= 0"));
    return std::nullopt;
  }

  std::optional<Rational> required(std::string_view key) const {
    table_.require(key, find(key).meaning);
    return optional(key);
  }

  std::optional<Rational> value(std::string_view key, bool is_required) const {
    return is_required ? required(key) : optional(key);
  }

  /// Which of two ways to say the same is used; both and none are reported.
  Form form(Keys first, Keys second) const {
    const std::string expected = "either " + listed(first) + " or " + listed(second);
    const std::string_view first_key = first_present(first);
    if (first_key.empty()) {
      if (!first_present(second).empty()) return Form::second;
      table_.require(listed(first), expected);
      return Form::none;
    }
    if (first_present(second).empty()) return Form::first;
    for (const std::string_view key : second) {
      if (has(key)) table_.refuse(key, "found together with " + std::string(first_key) + ", expected " + expected);
    }
    return Form::both;
  }

  void refuse(std::string_view key, const std::string& expected) const {
    table_.refuse(key, "found " + in_quotes(table_.value(key)->text.text()) + ", expected " + expected);
  }

 private:
  static const Parameter& find(std::string_view key) {
    for (const Parameter& parameter : parameters) {
      if (parameter.key == key) return parameter;
    }
    throw std::logic_error("no parameter " + std::string(key));
  }

  std::string_view first_present(Keys keys) const {
    for (const std::string_view key : keys) {
      if (has(key)) return key;
    }
    return {};
  }

  TableReader table_;
};

class SceneReader {
 public:
  SceneReader(const TomlValue& root, Mistakes& mistakes) : root_(root, "", root_keys, mistakes), mistakes_(mistakes) {}

  Scene read(const std::string& file) {
    scene_.name = std::filesystem::path(file).stem().string();
    if (const PlacedText* name = root_.string("name")) scene_.name = name->text();
    const TomlValue* bicycle = section("bicycle", "a table with its parameters");
    const TomlValue* road = section("road", "a table with f and g");
    const TomlValue* force = section("force", "a table with the kind of the force");
    // The force comes first, as its kind decides whether L may be left out, and last, as P needs sigma.
    const ParameterReader force_in(force == nullptr ? no_table_ : *force, "[force]", force_keys, mistakes_);
    if (force != nullptr) read_kind(force_in.table());
    if (bicycle != nullptr) read_bicycle({*bicycle, "[bicycle]", bicycle_keys, mistakes_});
    if (road != nullptr) read_road({*road, "[road]", road_keys, mistakes_});
    read_force(force_in);
    return scene_;
  }

 private:
  const TomlValue* section(std::string_view name, std::string_view expected) const {
    return root_.require(name, expected) ? root_.table(name) : nullptr;
  }

  void read_kind(const TableReader& force) {
    force.require("kind", "\"internal\" or \"external\"");
    const PlacedText* kind = force.string("kind");
    if (kind == nullptr) return;
    if (const auto found = parse_force_kind(kind->text())) {
      scene_.force_kind = *found;
    } else {
      force.refuse("kind", "found " + in_quotes(kind->text()) + ", expected \"internal\" or \"external\"");
    }
  }

  void read_bicycle(const ParameterReader& in) {
    Bicycle<Rational>& bicycle = scene_.bicycle;
    const auto R = in.required("R");
    if (R) bicycle.R = *R;
    read_height(in, R);
    read_distances(in);
    bicycle.J = in.optional("J");
    const auto M = in.optional("M");
    bicycle.M = M.value_or(1);
    const Form inertias = in.form({"I1", "I2", "I3"}, {"M2", "M3"});
    read_inertias(in, inertias, R);
    const bool reduced = inertias == Form::second;
    if (reduced && M && *M != 1) in.refuse("M", "1" + instead_of_reduced);
    read_transmission(in, reduced);
    if (reduced && !in.has("L") && scene_.force_kind == ForceKind::internal) {
      scene_.notes.emplace_back("L is not given: sigma = 1 (L = R), and F is P");
      bicycle.L = bicycle.R;
    } else if (const auto L = in.required("L")) {
      bicycle.L = *L;
    }
  }

  void read_height(const ParameterReader& in, const std::optional<Rational>& R) {
    const Form form = in.form({"h"}, {"h0"});
    const auto h = in.optional("h");
    const auto h0 = in.optional("h0");
    if (!R) return;
    if (h && Rational(*h + *R) <= 0) in.refuse("h", "h > -R, the centre of mass above the road");
    if (form == Form::first && h) scene_.bicycle.h = *h;
    if (form == Form::second && h0) scene_.bicycle.h = *h0 - *R;
  }

  void read_distances(const ParameterReader& in) {
    const Form form = in.form({"b"}, {"b2", "b3"});
    const auto b = in.optional("b");
    const auto b2 = in.value("b2", form == Form::second);
    const auto b3 = in.value("b3", form == Form::second);
    if (b2 && b3 && Rational(*b2 + *b3) <= 0) in.refuse("b3", "b2 + b3 > 0, the front contact ahead of the rear one");
    if (form == Form::first && b) scene_.bicycle.b2 = scene_.bicycle.b3 = *b;
    if (form == Form::second && b2 && b3) {
      scene_.bicycle.b2 = *b2;
      scene_.bicycle.b3 = *b3;
    }
  }

  void read_inertias(const ParameterReader& in, Form form, const std::optional<Rational>& R) {
    const auto I1 = in.value("I1", form == Form::first);
    const auto I2 = in.value("I2", form == Form::first);
    const auto I3 = in.value("I3", form == Form::first);
    const auto M2 = in.value("M2", form == Form::second);
    const auto M3 = in.value("M3", form == Form::second);
    Bicycle<Rational>& bicycle = scene_.bicycle;
    if (form == Form::first && I1 && I2 && I3) {
      bicycle.I1 = *I1;
      bicycle.I2 = *I2;
      bicycle.I3 = *I3;
    }
    if (form == Form::second && M2 && M3 && R) {
      bicycle.I1 = 0;
      bicycle.I2 = *M2 * *R * *R;
      bicycle.I3 = *M3 * *R * *R;
      scene_.notes.emplace_back("M2 and M3 are given: M = 1, mu = 1, and I1 is counted in I2");
    }
  }

  void read_transmission(const ParameterReader& in, bool reduced) {
    Bicycle<Rational>& bicycle = scene_.bicycle;
    bicycle.r1 = bicycle.r2 = 1;
    if (reduced && !in.has("r1") && !in.has("r2") && !in.has("mu")) return;
    const Form form = in.form({"r1", "r2"}, {"mu"});
    const auto r1 = in.value("r1", form == Form::first);
    const auto r2 = in.value("r2", form == Form::first);
    const auto mu = in.optional("mu");
    if (form == Form::first && r1 && r2) {
      bicycle.r1 = *r1;
      bicycle.r2 = *r2;
      if (reduced && *r1 != *r2) in.refuse("r2", "r2 = r1" + instead_of_reduced);
    }
    if (form == Form::second && mu) {
      bicycle.r2 = *mu;
      if (reduced && *mu != 1) in.refuse("mu", "1" + instead_of_reduced);
      scene_.notes.emplace_back("mu is given: r1 = 1 m, and the tension T of the chain is relative to that");
    }
  }

  void read_road(const ParameterReader& in) {
    if (const auto f = in.required("f")) scene_.road.f = *f;
    if (const auto g = in.required("g")) scene_.road.g = *g;
  }

  void read_force(const ParameterReader& in) {
    scene_.F = in.optional("F");
    const auto P = in.optional("P");
    if (in.has("F") && in.has("P")) in.table().refuse("P", "found together with F, expected only one of them");
    if (in.has("P") && scene_.force_kind == ForceKind::external) {
      in.table().refuse("P", "found with an external force, expected F: P = F sigma is of an internal one");
    }
    if (!P || !mistakes_.empty()) return;
    if (sigma(scene_.bicycle).is_zero()) {
      in.table().refuse("P", "found with sigma = mu L/R = 0, expected F: every F gives P = 0");
    } else {
      scene_.F = *P / sigma(scene_.bicycle);
    }
  }

  static inline const std::string instead_of_reduced = " together with M2, M3, or I1, I2, I3 instead of them";

  const TomlValue no_table_{};
  TableReader root_;
  Mistakes& mistakes_;
  Scene scene_;
};

}  // namespace

Scene parse_scene(std::string_view text, const std::string& file) {
  Mistakes mistakes(file);
  const auto root = parse_toml(text, mistakes);
  Scene scene;
  if (root) scene = SceneReader(*root, mistakes).read(file);
  mistakes.refuse_if_any();
  return scene;
}

Scene read_scene(const std::filesystem::path& path) {
  return parse_scene(read_text_file(path), path.string());
}

}  // namespace slipproof
