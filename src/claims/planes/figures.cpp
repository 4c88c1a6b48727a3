#include "claims/planes/figures.hpp"

#include <algorithm>
#include <array>

#include "base/input/table_reader.hpp"
#include "base/input/text_file.hpp"

namespace slipproof {

namespace {

constexpr std::string_view schema = "slipproof/figures/1";
constexpr std::array<std::string_view, 2> root_keys{"schema", "figure"};
constexpr std::array<std::string_view, 11> figure_keys{"id",   "title",  "note", "setting", "x",     "x_from",
                                                       "x_to", "y_from", "y_to", "y_label", "values"};

class FigureReader {
 public:
  FigureReader(const TomlValue& table, const ClaimsFile& claims, Mistakes& mistakes)
      : table_(table, "figure", figure_keys, mistakes), claims_(claims), mistakes_(mistakes) {}

  Figure read() {
    Figure figure;
    figure.id = text("id", true);
    const auto plain = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
    };
    if (!std::all_of(figure.id.begin(), figure.id.end(), plain)) table_.refuse("id", "expected letters, digits and -");
    figure.title = text("title", true);
    figure.note = text("note", false);
    figure.y_label = text("y_label", false);
    range("x_from", "x_to", figure.x_from, figure.x_to);
    range("y_from", "y_to", figure.y_from, figure.y_to);
    const std::string setting = text("setting", true), x = text("x", true);
    const auto& settings = claims_.settings;
    const auto found = std::find_if(settings.begin(), settings.end(), [&](const auto& s) { return s.id == setting; });
    if (found == settings.end()) {
      if (!setting.empty()) table_.refuse("setting", "the claims have no setting " + in_quotes(setting));
      return figure;
    }
    figure.setting = static_cast<std::size_t>(found - settings.begin());
    if (found->force.symbol.empty()) table_.refuse("setting", in_quotes(setting) + " has no load, expected one");
    if (figure.y_label.empty()) figure.y_label = found->force.symbol;
    values(*found, x, figure);
    return figure;
  }

 private:
  std::string text(std::string_view key, bool required) const {
    if (required && !table_.require(key, "a string")) return {};
    const PlacedText* value = table_.string(key);
    return value ? value->text() : std::string();
  }

  void range(std::string_view from_key, std::string_view to_key, Rational& from, Rational& to) const {
    if (!table_.require(from_key, "a number") || !table_.require(to_key, "a number")) return;
    const auto low = table_.number(from_key), high = table_.number(to_key);
    if (!low || !high) return;
    from = *low;
    to = *high;
    if (!(from < to)) table_.refuse(to_key, "expected more than " + std::string(from_key));
  }

  void values(const Setting& setting, std::string_view x, Figure& figure) const {
    std::vector<std::string_view> symbols;
    for (const FreeParameter& parameter : setting.parameters) symbols.push_back(parameter.symbol);
    const auto at = std::find(symbols.begin(), symbols.end(), x);
    if (at == symbols.end() && !x.empty()) table_.refuse("x", "the setting has no parameter " + in_quotes(x));
    figure.x = static_cast<std::size_t>(at - symbols.begin());
    figure.values.assign(symbols.size(), Rational(0));
    if (!table_.require("values", "a table")) return;
    const TomlValue* given = table_.table("values");
    if (given == nullptr) return;
    const TableReader reader(*given, "values", symbols, mistakes_);
    for (std::size_t k = 0; k < symbols.size(); ++k) {
      if (k == figure.x || !reader.require(symbols[k], "a number")) continue;
      if (const auto number = reader.number(symbols[k])) figure.values[k] = *number;
    }
  }

  TableReader table_;
  const ClaimsFile& claims_;
  Mistakes& mistakes_;
};

}  // namespace

std::vector<Figure> parse_figures(std::string_view text, const std::string& file, const ClaimsFile& claims) {
  Mistakes mistakes(file);
  std::vector<Figure> figures;
  if (const auto root = parse_toml(text, mistakes)) {
    const TableReader reader(*root, "", root_keys, mistakes);
    if (reader.require("schema", std::string(schema))) {
      const PlacedText* value = reader.string("schema");
      if (value && value->text() != schema) reader.refuse("schema", "expected " + std::string(schema));
    }
    for (const TomlValue* table : reader.tables("figure")) {
      figures.push_back(FigureReader(*table, claims, mistakes).read());
      const auto same = [&](const Figure& other) { return other.id == figures.back().id; };
      if (std::count_if(figures.begin(), figures.end(), same) > 1) mistakes.add(table->place, "id: given twice");
    }
  }
  mistakes.refuse_if_any();
  return figures;
}

std::vector<Figure> read_figures(const std::filesystem::path& path, const ClaimsFile& claims) {
  return parse_figures(read_found_file(path), path.string(), claims);
}

}  // namespace slipproof
