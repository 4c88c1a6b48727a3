#include <array>

#include "mechanics/reading/reader.hpp"

namespace slipproof::mechanism_reader {

namespace {

/// Reads the tables that give names.
class SymbolReader {
 public:
  SymbolReader(const TableReader& root, Context& context)
      : root_(root), context_(context), mechanism_(context.mechanism) {}

  void read() {
    each("parameters", [&](const TomlEntry& entry) { read_parameter(entry); });
    each("definitions", [&](const TomlEntry& entry) {
      context_.declare(entry.key, entry.place);
      mechanism_.definitions.push_back(
          {entry.key, context_.expression(entry.value, entry.key, Sort::number), entry.place});
    });
    each("assume", [&](const TomlEntry& entry) {
      mechanism_.assume.push_back({entry.key, context_.condition(entry.value, entry.key)});
    });
    each("realisable", [&](const TomlEntry& entry) {
      mechanism_.realisable.push_back({entry.key, context_.condition(entry.value, entry.key)});
    });
    each("angles", [&](const TomlEntry& entry) { read_angle(entry); });
    if (const TomlValue* load = root_.table("load")) read_load(*load);
    if (root_.has("body")) return;  // the unknowns follow
    if (root_.require("unknowns", "the table [unknowns]")) {
      if (const TomlValue* unknowns = root_.table("unknowns")) read_unknowns(*unknowns);
    }
  }

 private:
  /// The entries of a table whose keys are free.
  template <class Read>
  void each(std::string_view key, Read&& read) {
    const TomlValue* table = root_.table(key);
    if (table == nullptr || !within(table->entries.size(), max_symbols, key, table->place, context_.mistakes)) return;
    for (const TomlEntry& entry : table->entries) read(entry);
  }

  void read_parameter(const TomlEntry& entry) {
    context_.declare(entry.key, entry.place);
    MechanismParameter parameter;
    parameter.symbol = entry.key;
    parameter.place = entry.place;
    parameter.domain = {make_truth(true), {}};
    if (entry.value.kind == TomlValue::Kind::table) {
      static constexpr std::array<std::string_view, 4> keys{"domain", "unit", "meaning", "optional"};
      const TableReader table(entry.value, "the parameter " + entry.key, keys, context_.mistakes);
      parameter.domain = context_.condition(table, "domain");
      parameter.unit = context_.text(table, "unit");
      parameter.meaning = context_.text(table, "meaning");
      parameter.optional = table.boolean("optional").value_or(false);
    } else if (entry.value.kind == TomlValue::Kind::string) {
      parameter.domain = context_.condition(entry.value, entry.key);
    } else {
      context_.mistakes.add(entry.value.place, entry.key + ": found " + std::string(kind_name(entry.value.kind)) +
                                                   ", expected a domain such as \"" + entry.key +
                                                   " > 0\", or { domain = ..., unit = ..., meaning = ... }");
    }
    mechanism_.parameters.push_back(std::move(parameter));
  }

  void read_angle(const TomlEntry& entry) {
    MechanismAngle angle;
    angle.name = entry.key;
    angle.place = entry.place;
    angle.domain = {make_truth(true), {}};
    context_.declare(entry.key, entry.place);
    if (entry.value.kind != TomlValue::Kind::table) {
      context_.mistakes.add(entry.value.place, entry.key + ": found " + std::string(kind_name(entry.value.kind)) +
                                                   ", expected { cos = \"c\", sin = \"s\" }");
      return;
    }
    static constexpr std::array<std::string_view, 4> keys{"cos", "sin", "domain", "meaning"};
    const TableReader table(entry.value, "the angle " + entry.key, keys, context_.mistakes);
    angle.cosine = context_.required(table, "cos", "the symbol of the cosine");
    if (!angle.cosine.empty()) context_.declare(angle.cosine, table.place("cos"));
    angle.sine = context_.required(table, "sin", "the symbol of the sine");
    if (!angle.sine.empty()) context_.declare(angle.sine, table.place("sin"));
    angle.domain = context_.condition(table, "domain");
    angle.meaning = context_.text(table, "meaning");
    mechanism_.angles.push_back(std::move(angle));
  }

  void read_load(const TomlValue& value) {
    static constexpr std::array<std::string_view, 4> keys{"symbol", "domain", "unit", "meaning"};
    const TableReader table(value, "[load]", keys, context_.mistakes);
    MechanismLoad load;
    load.place = value.place;
    load.symbol = context_.required(table, "symbol", "the symbol of the load");
    if (!load.symbol.empty()) context_.declare(load.symbol, table.place("symbol"));
    load.domain.push_back(context_.condition(table, "domain"));
    load.unit = context_.text(table, "unit");
    load.meaning = context_.text(table, "meaning");
    mechanism_.load = std::move(load);
  }

  void read_unknowns(const TomlValue& value) {
    using Role = MechanismUnknown::Role;
    static constexpr std::array<std::string_view, 2> keys{"accelerations", "forces"};
    const TableReader table(value, "[unknowns]", keys, context_.mistakes);
    table.require("accelerations", "an array with at least one symbol");
    mechanism_.accelerations = read_unknowns(table, "accelerations", Role::acceleration);
    mechanism_.forces = read_unknowns(table, "forces", Role::force);
    const TomlValue* accelerations = table.value("accelerations");
    if (accelerations != nullptr && accelerations->kind == TomlValue::Kind::array && accelerations->items.empty()) {
      table.refuse("accelerations", "found none, expected at least one");
    }
  }

  std::size_t read_unknowns(const TableReader& table, std::string_view key, MechanismUnknown::Role role) {
    std::size_t count = 0;
    const auto names = table.strings(key);
    if (!within(names.size(), max_unknowns, key, table.place(key), context_.mistakes)) return 0;
    for (const PlacedText* name : names) {
      context_.declare(name->text(), name->at(0));
      mechanism_.unknowns.push_back({name->text(), role, 0, {}, name->at(0)});
      ++count;
    }
    return count;
  }

  const TableReader& root_;
  Context& context_;
  Mechanism& mechanism_;
};

}  // namespace

void read_symbols(const TableReader& root, Context& context) {
  SymbolReader(root, context).read();
}

}  // namespace slipproof::mechanism_reader
