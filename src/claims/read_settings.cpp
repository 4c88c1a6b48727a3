#include <algorithm>

#include "claims/claims_reader.hpp"
#include "claims/inherit.hpp"
#include "expression/parser.hpp"

namespace slipproof::claims_reader {

namespace {

using Keys = std::initializer_list<std::string_view>;

class SettingReader {
 public:
  SettingReader(const TableReader& table, Context& context)
      : table_(table), context_(context), index_(context.file.settings.size()) {}

  void read() {
    setting_.id = context_.text(table_, "id", "a name of the setting");
    context_.optional_text(table_, "inherits");  // followed by written_out(), reported here if it is no text
    setting_.statement = context_.optional_text(table_, "statement");
    setting_.line = context_.line(table_, "line", false);
    const auto& others = context_.file.settings;
    if (std::any_of(others.begin(), others.end(), [&](const Setting& other) { return other.id == setting_.id; })) {
      table_.refuse("id", "found " + in_quotes(setting_.id) + " a second time, expected another name");
    }
    read_strictness();
    read_parameters();
    read_force();
    read_definitions();
    read_scene();
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

  // A name that nothing else in the setting has.
  void declare(const std::string& symbol, Place place) {
    if (!is_symbol_name(symbol)) {
      context_.mistakes.add(place, "found " + in_quotes(symbol) +
                                       ", expected a symbol: a letter, then letters, digits "
                                       "and underscores, and no word of the language");
    } else if (parse_quantity(symbol)) {
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
    if (!table_.require("parameters", "the table [setting.parameters]")) return;
    const TomlValue* parameters = table_.table("parameters");
    if (parameters == nullptr) return;
    for (const TomlEntry& entry : parameters->entries) {
      declare(entry.key, entry.place);
      Parameter parameter{entry.key, make_truth(true), {}, 0};
      if (entry.value.kind == TomlValue::Kind::table) {
        static constexpr std::array<std::string_view, 3> keys{"domain", "meaning", "line"};
        const TableReader table(entry.value, "the parameter " + entry.key, keys, context_.mistakes);
        if (table.require("domain", "a condition such as \"R > 0\"")) {
          parameter.domain = context_.expression(table, "domain", Sort::truth, index_, {});
        }
        parameter.meaning = context_.text(table, "meaning", "what the symbol stands for");
        parameter.line = context_.line(table, "line", false);
      } else {
        context_.mistakes.add(entry.value.place, entry.key + ": found " + std::string(kind_name(entry.value.kind)) +
                                                     ", expected { domain = ..., meaning = ... }");
      }
      setting_.parameters.push_back(std::move(parameter));
    }
  }

  void read_force() {
    setting_.force.domain = make_truth(true);
    if (!table_.require("force", "the table [setting.force]")) return;
    const TomlValue* force = table_.table("force");
    if (force == nullptr) return;
    static constexpr std::array<std::string_view, 4> keys{"symbol", "kind", "domain", "line"};
    const TableReader table(*force, "[setting.force]", keys, context_.mistakes);
    setting_.force.symbol = context_.text(table, "symbol", "the paper's symbol of the force");
    if (table.string("symbol") != nullptr) declare(setting_.force.symbol, table.place("symbol"));
    const std::string kind = context_.text(table, "kind", "\"internal\" or \"external\"");
    if (table.string("kind") != nullptr && kind != "internal" && kind != "external") {
      table.refuse("kind", "found " + in_quotes(kind) + ", expected \"internal\" or \"external\"");
    }
    setting_.force_kind = kind == "external" ? ForceKind::external : ForceKind::internal;
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

  void read_scene() {
    if (!table_.require("scene", "the table [setting.scene]")) return;
    const TomlValue* scene = table_.table("scene");
    if (scene == nullptr) return;
    const TableReader table(*scene, "[setting.scene]", scene_symbols, context_.mistakes);
    for (const std::string_view symbol : scene_symbols) {
      if (symbol == "J" && !table.has(symbol)) continue;
      table.require(symbol, "an expression over the parameters");
      setting_.scene.emplace(symbol,
                             context_.expression(table, symbol, Sort::number, index_, {.force = symbol == "F"}));
    }
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
    for (const Parameter& parameter : setting_.parameters) parameters.push_back(parameter.symbol);
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
  std::vector<std::string> declared_;
};

}  // namespace

void read_settings(const TableReader& root, Context& context) {
  static constexpr std::array<std::string_view, 11> keys{"id",      "inherits",   "statement", "line",
                                                         "motions", "parameters", "force",     "definition",
                                                         "scene",   "boundaries", "realisable"};
  if (!root.require("setting", "at least one table [[setting]]")) return;
  for (const TomlValue& value : written_out(root.tables("setting"), context.mistakes)) {
    const TableReader table(value, "[[setting]]", keys, context.mistakes);
    SettingReader(table, context).read();
  }
}

}  // namespace slipproof::claims_reader
