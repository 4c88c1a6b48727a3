#include "mechanics/scene/bicycle_scene.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <span>

#include "base/input/table_reader.hpp"
#include "base/output/listed.hpp"
#include "mechanics/reading/shipped.hpp"

namespace slipproof {

namespace {

enum class KeyDomain { any, not_negative, positive };

/// What a key of a scene means; the message about a missing one says so.
struct BicycleKey {
  std::string_view key;
  std::string_view meaning;
  KeyDomain domain;
};

constexpr std::array<BicycleKey, 21> known_keys{{
    {"R", "the radius of both wheels in m", KeyDomain::positive},
    {"h", "the height of the centre of mass above the axles in m", KeyDomain::any},
    {"h0", "the height of the centre of mass above the road in m", KeyDomain::positive},
    {"b", "the distance b2 = b3 of the centre of mass from each contact in m", KeyDomain::positive},
    {"b2", "the horizontal distance of the centre of mass from the rear contact in m", KeyDomain::any},
    {"b3", "the horizontal distance of the centre of mass from the front contact in m", KeyDomain::any},
    {"I1", "the moment of inertia of the sprocket in kg m^2", KeyDomain::not_negative},
    {"I2", "the moment of inertia of the rear wheel in kg m^2", KeyDomain::not_negative},
    {"I3", "the moment of inertia of the front wheel in kg m^2", KeyDomain::not_negative},
    {"M2", "(I1 + I2)/R^2 for M = 1", KeyDomain::not_negative},
    {"M3", "I3/R^2 for M = 1", KeyDomain::not_negative},
    {"r1", "the radius of the pedal sprocket in m", KeyDomain::positive},
    {"r2", "the radius of the rear sprocket in m", KeyDomain::positive},
    {"mu", "the gear ratio r2/r1", KeyDomain::positive},
    {"L", "the arm of the pedal in m", KeyDomain::any},
    {"M", "the total mass in kg", KeyDomain::positive},
    {"J", "the pitch inertia of the frame in kg m^2", KeyDomain::positive},
    {"f", "the coefficient of friction", KeyDomain::not_negative},
    {"g", "gravity in m/s^2", KeyDomain::positive},
    {"F", "the pedal force in N", KeyDomain::any},
    {"P", "F sigma in N", KeyDomain::any},
}};

constexpr std::array<std::string_view, 4> bicycle_root_keys{"name", "bicycle", "road", "force"};
constexpr std::array<std::string_view, 17> bicycle_keys{"R",  "h",  "h0", "b",  "b2", "b3", "I1", "I2", "I3",
                                                        "M2", "M3", "r1", "r2", "mu", "L",  "M",  "J"};
constexpr std::array<std::string_view, 2> road_keys{"f", "g"};
constexpr std::array<std::string_view, 3> force_keys{"kind", "F", "P"};

/// Of two ways to say the same thing, the one that a scene uses.
enum class Form { first, second, both, none };

using Keys = std::initializer_list<std::string_view>;

/// Reads the parameters of one table, judges each by its domain, and remembers nothing of those that failed.
class KeyReader {
 public:
  KeyReader(const TomlValue& table, const std::string& name, std::span<const std::string_view> keys, Mistakes& mistakes)
      : table_(table, name, keys, mistakes) {}

  const TableReader& table() const { return table_; }
  bool has(std::string_view key) const { return table_.has(key); }

  std::optional<Rational> optional(std::string_view key) const {
    auto value = table_.number(key);
    if (!value) return value;
    const BicycleKey& parameter = find(key);
    const bool inside = parameter.domain == KeyDomain::any || sign(*value) > 0 ||
                        (parameter.domain == KeyDomain::not_negative && sign(*value) == 0);
    if (inside) return value;
    refuse(key, std::string(key) + (parameter.domain == KeyDomain::positive ? " > 0" : " >= 0"));
    return std::nullopt;
  }

  std::optional<Rational> value(std::string_view key, bool is_required) const {
    if (is_required) table_.require(key, find(key).meaning);
    return optional(key);
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
  static const BicycleKey& find(std::string_view key) { return *std::ranges::find(known_keys, key, &BicycleKey::key); }

  std::string_view first_present(Keys keys) const {
    const auto found = std::ranges::find_if(keys, [&](std::string_view key) { return has(key); });
    return found == keys.end() ? std::string_view() : *found;
  }

  TableReader table_;
};

class BicycleReader {
 public:
  BicycleReader(const TomlValue& root, Mistakes& mistakes)
      : root_(root, "", bicycle_root_keys, mistakes), mistakes_(mistakes) {}

  MechanismScene read(const std::string& file) {
    scene_.mechanism = bicycle_mechanism();
    scene_.values = default_values(scene_.mechanism);
    scene_.name = std::filesystem::path(file).stem().string();
    if (const PlacedText* name = root_.string("name")) scene_.name = name->text();
    const TomlValue* bicycle = section("bicycle", "a table with its parameters");
    const TomlValue* road = section("road", "a table with f and g");
    const TomlValue* force = section("force", "a table with the kind of the force");
    // The force comes first, as its kind decides whether L may be left out, and last, as P needs sigma.
    const KeyReader force_in(force == nullptr ? no_table_ : *force, "[force]", force_keys, mistakes_);
    if (force != nullptr) read_kind(force_in.table());
    if (bicycle != nullptr) read_bicycle({*bicycle, "[bicycle]", bicycle_keys, mistakes_});
    if (road != nullptr) read_road({*road, "[road]", road_keys, mistakes_});
    read_force(force_in);
    if (mistakes_.empty()) add_combined();
    return std::move(scene_);
  }

 private:
  Rational& value(std::string_view symbol) { return scene_.values.parameters[bicycle_parameter(symbol)]; }
  bool external() { return !value("external").is_zero(); }

  const TomlValue* section(std::string_view name, std::string_view expected) const {
    return root_.require(name, expected) ? root_.table(name) : nullptr;
  }

  void read_kind(const TableReader& force) {
    force.require("kind", "\"internal\" or \"external\"");
    const PlacedText* kind = force.string("kind");
    if (kind == nullptr) return;
    if (kind->text() == "external") {
      value("external") = 1;
    } else if (kind->text() != "internal") {
      force.refuse("kind", "found " + in_quotes(kind->text()) + ", expected \"internal\" or \"external\"");
    }
  }

  /// A key that is a parameter of the mechanism.
  bool read(const KeyReader& in, std::string_view key, bool is_required = true) {
    const auto found = in.value(key, is_required);
    if (found) value(key) = *found;
    return found.has_value();
  }

  void read_bicycle(const KeyReader& in) {
    const bool R = read(in, "R");
    read_height(in, R);
    read_distances(in);
    scene_.values.given[bicycle_parameter("J")] = read(in, "J", false);
    value("M") = 1;
    read(in, "M", false);
    const Form inertias = in.form({"I1", "I2", "I3"}, {"M2", "M3"});
    read_inertias(in, inertias, R);
    const bool reduced = inertias == Form::second;
    if (reduced && value("M") != 1) in.refuse("M", "1" + instead_of_reduced);
    read_transmission(in, reduced);
    if (reduced && !in.has("L") && !external()) {
      scene_.notes.emplace_back("L is not given: sigma = 1 (L = R), and F is P");
      value("L") = value("R");
    } else {
      read(in, "L");
    }
  }

  void read_height(const KeyReader& in, bool has_R) {
    const Form form = in.form({"h"}, {"h0"});
    const auto h = in.optional("h");
    const auto h0 = in.optional("h0");
    if (!has_R) return;
    const Rational R = value("R");
    if (h && Rational(*h + R) <= 0) in.refuse("h", "h > -R, the centre of mass above the road");
    if (form == Form::first && h) value("h") = *h;
    if (form == Form::second && h0) value("h") = *h0 - R;
  }

  void read_distances(const KeyReader& in) {
    const Form form = in.form({"b"}, {"b2", "b3"});
    const auto b = in.optional("b");
    const bool b2 = read(in, "b2", form == Form::second), b3 = read(in, "b3", form == Form::second);
    if (b2 && b3 && Rational(value("b2") + value("b3")) <= 0) {
      in.refuse("b3", "b2 + b3 > 0, the front contact ahead of the rear one");
    }
    if (form == Form::first && b) value("b2") = value("b3") = *b;
  }

  void read_inertias(const KeyReader& in, Form form, bool has_R) {
    for (const std::string_view key : {"I1", "I2", "I3"}) read(in, key, form == Form::first);
    const auto M2 = in.value("M2", form == Form::second);
    const auto M3 = in.value("M3", form == Form::second);
    if (form != Form::second || !M2 || !M3 || !has_R) return;
    const Rational square = value("R") * value("R");
    value("I1") = 0;
    value("I2") = *M2 * square;
    value("I3") = *M3 * square;
    scene_.notes.emplace_back("M2 and M3 are given: M = 1, mu = 1, and I1 is counted in I2");
  }

  void read_transmission(const KeyReader& in, bool reduced) {
    value("r1") = value("r2") = 1;
    if (reduced && !in.has("r1") && !in.has("r2") && !in.has("mu")) return;
    const Form form = in.form({"r1", "r2"}, {"mu"});
    const bool r1 = read(in, "r1", form == Form::first), r2 = read(in, "r2", form == Form::first);
    const auto mu = in.optional("mu");
    if (form == Form::first && r1 && r2 && reduced && value("r1") != value("r2")) {
      in.refuse("r2", "r2 = r1" + instead_of_reduced);
    }
    if (form == Form::second && mu) {
      value("r2") = *mu;
      if (reduced && *mu != 1) in.refuse("mu", "1" + instead_of_reduced);
      scene_.notes.emplace_back("mu is given: r1 = 1 m, and the tension T of the chain is relative to that");
    }
  }

  void read_road(const KeyReader& in) {
    read(in, "f");
    read(in, "g");
  }

  void read_force(const KeyReader& in) {
    scene_.load = in.optional("F");
    const auto P = in.optional("P");
    if (in.has("F") && in.has("P")) in.table().refuse("P", "found together with F, expected only one of them");
    if (in.has("P") && external()) {
      in.table().refuse("P", "found with an external force, expected F: P = F sigma is of an internal one");
    }
    if (!P || !mistakes_.empty()) return;
    const Rational sigma = value("r2") * value("L") / (value("r1") * value("R"));
    if (sigma.is_zero()) {
      in.table().refuse("P", "found with sigma = mu L/R = 0, expected F: every F gives P = 0");
    } else {
      scene_.load = *P / sigma;
    }
  }

  /// What a scene may say in place of parameters may be varied in their place, too.
  void add_combined() {
    scene_.combined = {{"b", "m", (value("b2") + value("b3")) / 2, {{"b2", {0, 1}}, {"b3", {0, 1}}}},
                       {"h0", "m", value("h") + value("R"), {{"h", {-value("R"), 1}}}},
                       {"mu", "1", value("r2") / value("r1"), {{"r2", {0, value("r1")}}}}};
  }

  static inline const std::string instead_of_reduced = " together with M2, M3, or I1, I2, I3 instead of them";

  const TomlValue no_table_{};
  TableReader root_;
  Mistakes& mistakes_;
  MechanismScene scene_;
};

}  // namespace

const Mechanism& bicycle_mechanism() {
  static const Mechanism mechanism = read_shipped(*find_shipped("bicycle"));
  return mechanism;
}

std::size_t bicycle_parameter(std::string_view symbol) {
  const auto& all = bicycle_mechanism().parameters;
  return static_cast<std::size_t>(std::ranges::find(all, symbol, &MechanismParameter::symbol) - all.begin());
}

bool is_bicycle(const Mechanism& mechanism) {
  const Mechanism& own = bicycle_mechanism();
  const auto same = [](const auto& x, const auto& y) { return x.symbol == y.symbol; };
  return mechanism.name == own.name && std::ranges::equal(mechanism.parameters, own.parameters, same) &&
         std::ranges::equal(mechanism.unknowns, own.unknowns, same);
}

MechanismScene read_bicycle_scene(const TomlValue& document, const std::string& file, Mistakes& mistakes) {
  return BicycleReader(document, mistakes).read(file);
}

}  // namespace slipproof
