// Reads the mechanism of a setting, and the values of its symbols in terms of the paper's.
#include <algorithm>
#include <array>
#include <filesystem>

#include "claims/reading/claims_reader.hpp"
#include "mechanics/bodies/identity.hpp"
#include "mechanics/kernel/mode_solver.hpp"
#include "mechanics/mechanism/algebra.hpp"
#include "mechanics/mechanism/forms.hpp"
#include "mechanics/reading/impact_law.hpp"
#include "mechanics/scene/bicycle_scene.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof::claims_reader {

namespace {

/// Null if it is missing or not a text; that is reported with the force.
const TomlValue* force_kind(const TableReader& setting) {
  const TomlValue* force = setting.table("force");
  const TomlEntry* kind = force == nullptr ? nullptr : force->find("kind");
  return kind == nullptr || kind->value.kind != TomlValue::Kind::string ? nullptr : &kind->value;
}

/// Reads the bicycle of a setting that says where the force comes from.
bool read_bicycle(const TableReader& table, Context& context, Setting& setting) {
  setting.mechanism = std::shared_ptr<const Mechanism>(&bicycle_mechanism(), [](const Mechanism*) {});
  setting.starts = starts(*setting.mechanism);
  setting.mechanism_name = "bicycle";
  for (const char* key : {"state", "along", "law"}) {
    if (table.has(key)) table.refuse(key, "found without `mechanism`, expected it only beside one");
  }
  const TomlValue* kind = force_kind(table);
  if (kind != nullptr && kind->text.text() != "internal" && kind->text.text() != "external") {
    context.mistakes.add(kind->place,
                         "kind: found " + in_quotes(kind->text.text()) + ", expected \"internal\" or \"external\"");
  }
  return true;
}

class SceneReader {
 public:
  SceneReader(const TableReader& table, Context& context, Setting& setting)
      : table_(table), context_(context), setting_(setting), index_(context.file.settings.size()) {}

  void read() {
    if (of_bicycle(table_) && !table_.require("scene", "the table [setting.scene]")) return;
    TomlValue empty;
    empty.kind = TomlValue::Kind::table;
    empty.place = table_.place("scene");
    const TomlValue* scene = table_.has("scene") ? table_.table("scene") : &empty;
    if (scene == nullptr) return;
    const std::vector<std::string_view> keys = known_keys();
    const TableReader reader(*scene, "[setting.scene]", keys, context_.mistakes);
    for (const MechanismParameter& parameter : setting_.mechanism->parameters) {
      if (!is_force_kind(parameter.symbol)) read_number(reader, parameter.symbol, parameter.optional);
    }
    for (const MechanismAngle& angle : setting_.mechanism->angles) read_angle(reader, angle);
    if (setting_.mechanism->load) read_number(reader, setting_.mechanism->load->symbol, false);
    if (of_bicycle(table_)) {
      const TomlValue* kind = force_kind(table_);
      setting_.scene.emplace("external", make_number(kind != nullptr && kind->text.text() == "external" ? 1 : 0));
    }
    complete();
    refuse_open_without_lift();
    setting_.restrict_force_to_load();
  }

 private:
  /// Whether a setting gives this parameter of the bicycle as the kind of the force.
  bool is_force_kind(std::string_view parameter) const { return of_bicycle(table_) && parameter == "external"; }

  std::vector<std::string_view> known_keys() const {
    std::vector<std::string_view> keys = value_names(*setting_.mechanism);
    std::erase_if(keys, [&](std::string_view key) { return is_force_kind(key); });
    return keys;
  }

  bool is_load(std::string_view symbol) const {
    return setting_.mechanism->load && setting_.mechanism->load->symbol == symbol;
  }

  /// Whether the paper has a symbol that may stand for the mechanism's symbol of the same name.
  bool has_symbol(const std::string& symbol) const {
    const auto& all = setting_.parameters;
    return (is_load(symbol) && setting_.force.symbol == symbol) ||
           std::any_of(all.begin(), all.end(), [&](const FreeParameter& p) { return !p.angle && p.symbol == symbol; });
  }

  void read_number(const TableReader& reader, const std::string& symbol, bool optional) {
    if (!reader.has(symbol)) {
      // Settings of the bicycle must give every symbol, so that a forgotten one is a mistake.
      if (!of_bicycle(table_) && has_symbol(symbol)) {
        setting_.scene.emplace(symbol, make_symbol(symbol));
      } else if (!optional) {
        reader.require(symbol, "an expression over the parameters");
      }
      return;
    }
    setting_.scene.emplace(symbol, context_.expression(reader, symbol, Sort::number, index_,
                                                       {.definitions = false, .force = is_load(symbol)}));
  }

  void read_angle(const TableReader& reader, const MechanismAngle& angle) {
    const auto put = [&](const Expression& cosine, const Expression& sine) {
      setting_.scene.emplace(angle.cosine, cosine);
      setting_.scene.emplace(angle.sine, sine);
    };
    if (!reader.has(angle.name)) {
      const auto& own = setting_.angles;
      const auto same = std::find_if(own.begin(), own.end(), [&](const FreeAngle& a) { return a.name == angle.name; });
      if (same != own.end()) return put(make_symbol(same->cosine), make_symbol(same->sine));
      reader.require(angle.name, "an angle such as { tan_half = \"t\" } or { cos = \"c\", sin = \"s\" }");
      return;
    }
    const TomlValue* value = reader.table(angle.name);
    if (value == nullptr) return;
    static constexpr std::array<std::string_view, 3> forms{"tan_half", "cos", "sin"};
    const TableReader form(*value, "the angle " + angle.name, forms, context_.mistakes);
    const auto number = [&](std::string_view key) { return context_.expression(form, key, Sort::number, index_, {}); };
    if (form.has("tan_half")) {
      if (form.has("cos") || form.has("sin"))
        return form.refuse("tan_half", "found beside cos or sin, expected one of the two");
      const Expression t = number("tan_half");
      const FreeAngle by_half{angle.name, {}, {}, 0};
      const auto with_t = [&](const Expression& e) { return substitute(e, angle.name, t); };
      return put(with_t(by_half.cosine_value()), with_t(by_half.sine_value()));
    }
    form.require("cos", "the cosine, over the parameters");
    form.require("sin", "the sine, over the parameters");
    put(number("cos"), number("sin"));
  }

  /// Reports a contact that is open from the start but has a state other than `lift`.
  void refuse_open_without_lift() {
    const auto& contacts = setting_.mechanism->contacts;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const auto missing = missing_for_lift(contacts[i], setting_.given());
      if (setting_.starts[i] != ElementKind::Start::open || missing.empty()) continue;
      context_.mistakes.add(table_.place("scene"), "the contact " + contacts[i].name +
                                                       " is open, and this is not modelled without " +
                                                       setting_.mechanism->parameters[missing.front()].symbol +
                                                       ", expected it in [setting.scene]");
    }
  }

  /// Reports what is missing; reading continues.
  void complete() {
    const auto fill = [&](const std::string& symbol) { setting_.scene.emplace(symbol, make_number(0)); };
    for (const MechanismParameter& parameter : setting_.mechanism->parameters) {
      if (!parameter.optional) fill(parameter.symbol);
    }
    for (const MechanismAngle& angle : setting_.mechanism->angles) {
      fill(angle.cosine);
      fill(angle.sine);
    }
    if (setting_.mechanism->load) fill(setting_.mechanism->load->symbol);
  }

  const TableReader& table_;
  Context& context_;
  Setting& setting_;
  std::size_t index_;
};

/// Whether claims know all states of a mechanism but slips in directions that are unknown; if not, reports why.
bool is_stated(const Mechanism& mechanism, const TableReader& table) {
  if (mechanism.dimension == 2) return true;
  for (const MechanismContact& contact : mechanism.contacts) {
    const auto refuse = [&](const std::string& found) {
      table.refuse("mechanism", "contact " + contact.name + ": found " + found);
      return false;
    };
    if (contact.bilateral && !contact.frictionless()) {
      return refuse("a guide with friction in space, expected one without");
    }
    if (contact.sliding.size() != 2) continue;
    const Expression &x = contact.sliding[0].expression, &y = contact.sliding[1].expression;
    const Expression beyond_1 = difference_of(sum_of(make_power(x, 2), make_power(y, 2)), make_number(1));
    if (!bodies_in_motion::vanishes_identically(mechanism, beyond_1)) {
      return refuse("a sliding velocity whose length is no rational expression, expected one such as (3*v, 4*v)");
    }
  }
  return true;
}

}  // namespace

bool read_mechanism(const TableReader& table, Context& context, Setting& setting) {
  if (!table.has("mechanism")) return read_bicycle(table, context, setting);
  setting.mechanism_name = context.optional_text(table, "mechanism");
  setting.along = context.optional_text(table, "along");
  MechanismRequest request(Dimensions::any);
  if (const auto law = read_impact_law(table)) request.impact = ImpactRequest{law};
  auto& known = context.mechanisms[{setting.mechanism_name, setting.along, context.optional_text(table, "law")}];
  if (!known) {
    auto opened = named_mechanism(table, std::filesystem::path(context.file.file).parent_path().string(), request);
    if (!opened || !is_stated(*opened, table)) return false;
    // In space modes are judged at one load: it is a parameter of the paper like all others.
    known = std::make_shared<const Mechanism>(opened->dimension == 3 ? without_load(*opened) : std::move(*opened));
  }
  setting.mechanism = known;
  setting.starts = starts(*known);
  if (const TomlValue* state = table.table("state")) read_states(*state, *known, setting.starts, context.mistakes);
  if (mode_count(setting.all_kinds()) <= static_cast<double>(max_modes)) return true;
  table.refuse("mechanism", "found more than " + std::to_string(max_modes) + " modes, expected a smaller mechanism");
  return false;
}

void read_scene(const TableReader& table, Context& context, Setting& setting) {
  SceneReader(table, context, setting).read();
}

}  // namespace slipproof::claims_reader
