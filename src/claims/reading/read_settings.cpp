#include <algorithm>

#include "base/expression/parser.hpp"
#include "claims/reading/claims_reader.hpp"
#include "claims/reading/inherit.hpp"
#include "mechanics/mechanism/units.hpp"

namespace slipproof::claims_reader {

namespace {

using Keys = std::initializer_list<std::string_view>;

class SettingReader {
 public:
  SettingReader(const TableReader& table, Context& context)
      : table_(table), context_(context), index_(context.file.settings.size()) {}

  void read() {
    setting_.id = context_.text(table_, "id", "a name of the setting");
    context_.optional_text(table_, "inherits");  // written_out() follows it; here it is reported if it is not a text
    setting_.statement = context_.optional_text(table_, "statement");
    setting_.line = context_.line(table_, "line", false);
    const auto& others = context_.file.settings;
    if (std::any_of(others.begin(), others.end(), [&](const Setting& other) { return other.id == setting_.id; })) {
      table_.refuse("id", "found " + in_quotes(setting_.id) + " a second time, expected another name");
    }
    // Without a mechanism the rest makes no sense.
    if (!read_mechanism(table_, context_, setting_)) context_.mistakes.refuse_if_any();
    quantities_ = setting_.quantities();
    read_strictness();
    read_parameters();
    read_angles();
    read_force();
    read_definitions();
    inherit();
    read_scene(table_, context_, setting_);
    for (const auto& [parameter, domain] : inherited_)
      setting_.parameters[parameter].domain = setting_.in_family(domain);
    for (const PlacedText* boundary : table_.strings("boundaries")) read_boundary(*boundary);
    read_realisable();
    context_.file.settings.push_back(std::move(setting_));
  }

 private:
  void read_strictness() {
    const std::string motions = context_.text(table_, "motions", "\"strict\" or \"closed\"");
    if (table_.string("motions") != nullptr && motions != "strict" && motions != "closed") {
      table_.refuse("motions", "found " + in_quotes(motions) + ", expected \"strict\" or \"closed\"");
    }
    setting_.strict = motions != "closed";
  }

  // Declares a name, which nothing else in the setting may have.
  void declare(const std::string& symbol, Place place) {
    if (!is_symbol_name(symbol)) {
      context_.mistakes.add(place, "found " + in_quotes(symbol) +
                                       ", expected a symbol: a letter, then letters, digits "
                                       "and underscores, and no word of the language");
    } else if (std::find(quantities_.begin(), quantities_.end(), symbol) != quantities_.end()) {
      context_.mistakes.add(place, "found " + in_quotes(symbol) +
                                       ", which is a quantity of every motion, expected "
                                       "another symbol");
    } else if (std::find(declared_.begin(), declared_.end(), symbol) != declared_.end()) {
      context_.mistakes.add(place, "found the symbol " + in_quotes(symbol) + " a second time in this setting");
    } else {
      declared_.push_back(symbol);
    }
  }

  void read_parameters() {
    if (of_bicycle(table_) && !table_.has("angles") &&
        !table_.require("parameters", "the table [setting.parameters]")) {
      return;
    }
    if (const TomlValue* parameters = table_.table("parameters")) {
      for (const TomlEntry& entry : parameters->entries) read_parameter(entry);
    }
  }

  void read_parameter(const TomlEntry& entry) {
    declare(entry.key, entry.place);
    FreeParameter parameter{entry.key, make_truth(true), {}, 0};
    if (entry.value.kind == TomlValue::Kind::table) {
      static constexpr std::array<std::string_view, 4> keys{"domain", "meaning", "line", "unit"};
      const TableReader table(entry.value, "the parameter " + entry.key, keys, context_.mistakes);
      const MechanismParameter* same = in_mechanism(entry.key);
      if (table.has("domain")) {
        parameter.domain = context_.expression(table, "domain", Sort::truth, index_, {});
      } else if (same != nullptr) {
        inherited_.emplace_back(setting_.parameters.size(), same->domain.expression);
      } else {
        table.require("domain", "a condition such as \"R > 0\"");
      }
      if (same != nullptr) parameter.meaning = same->meaning;
      if (same == nullptr || table.has("meaning"))
        parameter.meaning = context_.text(table, "meaning", "what the symbol stands for");
      parameter.line = context_.line(table, "line", false);
      check_unit(table, same != nullptr ? same->unit : std::string());
    } else {
      context_.mistakes.add(entry.value.place, entry.key + ": found " + std::string(kind_name(entry.value.kind)) +
                                                   ", expected { domain = ..., meaning = ... }");
    }
    setting_.parameters.push_back(std::move(parameter));
  }

  /// A unit says nothing in a claim; it must be one, and the mechanism's.
  void check_unit(const TableReader& table, const std::string& of_mechanism) {
    const PlacedText* text = table.string("unit");
    if (text == nullptr || !has_units()) return;
    const auto unit = parse_unit(text->text()), expected = parse_unit(of_mechanism);
    if (!unit) {
      table.refuse("unit", "found " + in_quotes(text->text()) + ", expected a unit such as \"kg m^2\", or \"1\"");
    } else if (!of_mechanism.empty() && expected && !(*unit == *expected)) {
      table.refuse("unit",
                   "found " + in_quotes(text->text()) + ", expected that of the mechanism, " + in_quotes(of_mechanism));
    }
  }

  bool is_declared(std::string_view symbol) const { return std::ranges::find(declared_, symbol) != declared_.end(); }
  bool in_scene(std::string_view symbol) const {
    const TomlValue* scene = table_.value("scene");
    return scene != nullptr && scene->find(symbol) != nullptr;
  }
  /// The parameter of the mechanism that a symbol of the paper is, by its name; null if there is none.
  const MechanismParameter* in_mechanism(std::string_view symbol) const {
    if (of_bicycle(table_) || in_scene(symbol)) return nullptr;
    const auto& all = setting_.mechanism->parameters;
    const auto found = std::ranges::find(all, symbol, &MechanismParameter::symbol);
    return found == all.end() ? nullptr : &*found;
  }

  /// What the setting does not say is as in the mechanism, where no name is taken. Its domains become the paper's when
  /// the scene is read.
  void inherit() {
    if (of_bicycle(table_)) return;
    const auto is_free = [&](const std::string& name) { return !in_scene(name) && !is_declared(name); };
    const auto add = [&](const std::string& symbol, const PlacedExpression& domain, const std::string& meaning,
                         std::optional<std::size_t> angle) {
      declare(symbol, table_.place("mechanism"));
      inherited_.emplace_back(setting_.parameters.size(), domain.expression);
      setting_.parameters.push_back({symbol, make_truth(true), meaning, 0, angle});
    };
    for (const MechanismParameter& one : setting_.mechanism->parameters) {
      if (!one.optional && is_free(one.symbol)) add(one.symbol, one.domain, one.meaning, {});
    }
    for (const MechanismAngle& one : setting_.mechanism->angles) {
      if (!is_free(one.name) || is_declared(one.cosine) || is_declared(one.sine)) continue;
      setting_.angles.push_back({one.name, one.cosine, one.sine, setting_.parameters.size()});
      add(one.name, one.domain, one.meaning, setting_.angles.size() - 1);
      for (const std::string& symbol : {one.cosine, one.sine}) declare(symbol, table_.place("mechanism"));
    }
  }

  void read_angles() {
    const TomlValue* angles = table_.table("angles");
    if (angles == nullptr) return;
    for (const TomlEntry& entry : angles->entries) {
      if (entry.value.kind != TomlValue::Kind::table) {
        context_.mistakes.add(entry.value.place, entry.key + ": found " + std::string(kind_name(entry.value.kind)) +
                                                     ", expected { cos = \"c\", sin = \"s\" }");
        continue;
      }
      static constexpr std::array<std::string_view, 5> keys{"cos", "sin", "domain", "meaning", "line"};
      const TableReader table(entry.value, "the angle " + entry.key, keys, context_.mistakes);
      declare(entry.key, entry.place);
      FreeAngle angle{entry.key, context_.text(table, "cos", "the symbol of its cosine"),
                      context_.text(table, "sin", "the symbol of its sine"), setting_.parameters.size()};
      for (const auto& [key, symbol] : {std::pair{"cos", angle.cosine}, {"sin", angle.sine}}) {
        if (table.string(key) != nullptr) declare(symbol, table.place(key));
      }
      FreeParameter half{entry.key, make_truth(true), context_.optional_text(table, "meaning"),
                         context_.line(table, "line", false), setting_.angles.size()};
      if (table.has("domain")) half.domain = context_.expression(table, "domain", Sort::truth, index_, {});
      setting_.angles.push_back(std::move(angle));
      setting_.parameters.push_back(std::move(half));
    }
  }

  void read_force() {
    setting_.force.domain = make_truth(true);
    const auto& load = setting_.mechanism->load;
    if (!of_bicycle(table_) && !table_.has("force")) {  // the mechanism's load with its own name
      if (!load) return;
      setting_.force.symbol = load->symbol;
      return declare(load->symbol, table_.place("mechanism"));
    }
    if (!table_.require("force", "the table [setting.force]")) return;
    const TomlValue* force = table_.table("force");
    if (force == nullptr) return;
    static constexpr std::array<std::string_view, 5> keys{"symbol", "kind", "domain", "line", "unit"};
    const TableReader table(*force, "[setting.force]", keys, context_.mistakes);
    check_unit(table, load && !of_bicycle(table_) ? load->unit : std::string());
    if (!load && setting_.mechanism->dimension == 3) {
      return table_.refuse("force",
                           "found beside a mechanism in space, expected none: there the load is one of the parameters, "
                           "with its symbol in [setting.parameters], and in [setting.scene] if it has another name");
    }
    if (!load) return table_.refuse("force", "found a force, but the mechanism has no load");
    setting_.force.symbol = context_.text(table, "symbol", "the paper's symbol of the force");
    if (table.string("symbol") != nullptr) declare(setting_.force.symbol, table.place("symbol"));
    if (of_bicycle(table_)) {
      context_.text(table, "kind", "\"internal\" or \"external\"");
    } else if (table.has("kind")) {
      table.refuse("kind", "found beside `mechanism`, expected it only for the bicycle of settings without one");
    }
    setting_.force.domain = context_.expression(table, "domain", Sort::truth, index_, {.force = true});
    setting_.force.line = context_.line(table, "line", false);
  }

  void read_definitions() {
    const auto definitions = table_.tables("definition");
    constexpr std::size_t at_most = 1'000;
    if (definitions.size() > at_most) {
      return table_.refuse("definition", "found " + std::to_string(definitions.size()) + ", expected at most 1000");
    }
    for (const TomlValue* definition : definitions) read_definition(*definition);
  }

  void read_definition(const TomlValue& value) {
    static constexpr std::array<std::string_view, 6> keys{"symbol", "equation", "line", "printed", "repaired", "why"};
    const TableReader table(value, "[[setting.definition]]", keys, context_.mistakes);
    Definition definition;
    definition.symbol = context_.text(table, "symbol", "the symbol that is defined");
    if (table.string("symbol") != nullptr) declare(definition.symbol, table.place("symbol"));
    definition.equation = context_.optional_text(table, "equation");
    definition.line = context_.line(table, "line", true);
    const Allowed allowed{.definitions = true, .force = true};
    table.require("printed", "the expression as printed");
    definition.printed = context_.expression(table, "printed", Sort::number, index_, allowed);
    if (table.has("repaired")) {
      definition.repaired = context_.expression(table, "repaired", Sort::number, index_, allowed);
      definition.why = context_.text(table, "why", "the reason for the repair");
      if (table.string("repaired") != nullptr && same(definition.printed, definition.repaired)) {
        table.refuse("repaired", "expected an expression other than the printed one");
      }
    } else if (table.has("why")) {
      table.refuse("why", "found a reason without `repaired`");
    }
    setting_.definitions.push_back(std::move(definition));
  }

  void read_realisable() {
    const TomlValue* realisable = table_.table("realisable");
    if (realisable == nullptr) return;
    std::vector<std::string_view> names;
    for (const TomlEntry& entry : realisable->entries) names.push_back(entry.key);
    const TableReader table(*realisable, "[setting.realisable]", names, context_.mistakes);
    for (const TomlEntry& entry : realisable->entries) {
      setting_.realisable.push_back(
          {entry.key, context_.expression(table, entry.key, Sort::truth, index_, {.definitions = true})});
    }
  }

  void read_boundary(const PlacedText& text) {
    Expression boundary = make_truth(true);
    try {
      boundary = parse_expression(text.text(), Sort::truth);
    } catch (const ExpressionError& error) {
      return context_.refuse(text, error.column() - 1, "boundaries", error.what());
    }
    if (boundary->operation != Operation::compare || boundary->relations != std::vector{Relation::equal} ||
        boundary->operands[0]->operation != Operation::symbol) {
      return context_.refuse(text, 0, "boundaries", "expected PARAMETER = EXPRESSION");
    }
    const std::string& symbol = boundary->operands[0]->symbol;
    std::vector<std::string_view> parameters;
    for (const FreeParameter& parameter : setting_.parameters) {
      if (!parameter.angle) parameters.push_back(parameter.symbol);
    }
    if (std::find(parameters.begin(), parameters.end(), symbol) == parameters.end()) {
      const std::size_t position = boundary->operands[0]->column - 1;
      return context_.refuse(text, position, "boundaries", unknown("parameter", symbol, parameters));
    }
    const Expression& value = boundary->operands[1];
    context_.uses.push_back({value, text, "boundaries", index_, {.definitions = true}, symbol});
    setting_.boundaries.push_back({symbol, value});
  }

  const TableReader& table_;
  Context& context_;
  std::size_t index_;
  Setting setting_;
  std::vector<std::string> declared_, quantities_;
  std::vector<std::pair<std::size_t, Expression>> inherited_;  ///< parameters, and their domains in the mechanism
};

}  // namespace

void read_settings(const TableReader& root, Context& context) {
  static constexpr std::array<std::string_view, 16> keys{
      "id",    "inherits",   "statement", "line",  "motions",    "mechanism", "along",      "law",
      "state", "parameters", "angles",    "force", "definition", "scene",     "boundaries", "realisable"};
  if (!root.require("setting", "at least one table [[setting]]")) return;
  for (const TomlValue& value : written_out(root.tables("setting"), context.mistakes)) {
    const TableReader table(value, "[[setting]]", keys, context.mistakes);
    SettingReader(table, context).read();
  }
}

}  // namespace slipproof::claims_reader
