#include "claims/reading/read_claims_file.hpp"

#include <charconv>

#include "base/expression/parser.hpp"
#include "base/input/near_match.hpp"
#include "base/input/text_file.hpp"
#include "claims/reading/claims_reader.hpp"

namespace slipproof {

namespace claims_reader {

std::string unknown(std::string_view what, std::string_view found, const std::vector<std::string_view>& known) {
  std::string message = "unknown " + std::string(what) + ' ' + in_quotes(found);
  if (const auto meant = near_match(found, known)) return message + ", did you mean '" + std::string(*meant) + "'?";
  message += ", expected one of";
  for (std::size_t i = 0; i < known.size(); ++i) message += (i == 0 ? " " : ", ") + std::string(known[i]);
  return message;
}

Expression Context::expression(const PlacedText& text, std::string_view key, Sort sort, std::size_t setting,
                               Allowed allowed) {
  try {
    Expression read = parse_expression(text.text(), sort);
    uses.push_back({read, text, std::string(key), setting, allowed, {}});
    return read;
  } catch (const ExpressionError& error) {
    refuse(text, error.column() - 1, key, error.what());
    return sort == Sort::truth ? make_truth(true) : make_number(0);
  }
}

Expression Context::expression(const TableReader& table, std::string_view key, Sort sort, std::size_t setting,
                               Allowed allowed) {
  if (const PlacedText* text = table.string(key)) return expression(*text, key, sort, setting, allowed);
  return sort == Sort::truth ? make_truth(true) : make_number(0);
}

std::string Context::text(const TableReader& table, std::string_view key, std::string_view expected) {
  return table.require(key, expected) ? optional_text(table, key) : std::string();
}

std::string Context::optional_text(const TableReader& table, std::string_view key) {
  const PlacedText* text = table.string(key);
  return text == nullptr ? std::string() : text->text();
}

std::size_t Context::line(const TableReader& table, std::string_view key, bool required) {
  if (required && !table.require(key, "the line in the paper's source")) return 0;
  const auto value = table.number(key);
  if (!value) return 0;
  if (denominator(*value) != 1 || *value < 1 || *value > 10'000'000) {
    table.refuse(key, "expected a line number, an integer from 1");
    return 0;
  }
  return static_cast<std::size_t>(numerator(*value).to_long());
}

Origin Context::origin(const TableReader& table, Origin otherwise) {
  const PlacedText* text = table.string("origin");
  if (text == nullptr) return otherwise;
  std::vector<std::string_view> names;
  for (const Origin known : all_origins) {
    if (text->text() == name(known)) return known;
    names.push_back(name(known));
  }
  table.refuse("origin", unknown("origin", text->text(), names));
  return otherwise;
}

namespace {

void read_headings(const TomlValue& table, Context& context) {
  std::vector<std::string_view> numbers;
  for (const TomlEntry& entry : table.entries) numbers.push_back(entry.key);
  const TableReader headings(table, "[paper.headings]", numbers, context.mistakes);
  for (const TomlEntry& entry : table.entries) {
    const std::string heading = context.text(headings, entry.key, "what begins on the line");
    std::size_t line = 0;
    const char* end = entry.key.data() + entry.key.size();
    const auto [stop, error] = std::from_chars(entry.key.data(), end, line);
    if (error != std::errc() || stop != end || line == 0) {
      headings.refuse(entry.key, "expected a line number as the key, an integer from 1");
    } else {
      context.file.paper.headings.emplace(line, heading);
    }
  }
}

void read_paper(const TableReader& root, Context& context) {
  if (!root.require("paper", "the table [paper]")) return;
  const TomlValue* table = root.table("paper");
  if (table == nullptr) return;
  static constexpr std::array<std::string_view, 11> keys{"title",  "authors",   "reference", "found",
                                                         "source", "equations", "headings",  "question",
                                                         "open",   "scenes",    "origin"};
  const TableReader paper(*table, "[paper]", keys, context.mistakes);
  context.file.paper.title = context.text(paper, "title", "the title of the paper");
  context.file.paper.source = context.text(paper, "source", "the name of the file that line numbers refer to");
  if (paper.require("authors", "an array of names")) {
    for (const PlacedText* author : paper.strings("authors")) context.file.paper.authors.push_back(author->text());
  }
  if (paper.has("reference")) {
    context.file.paper.reference = context.text(paper, "reference", "where the paper is published");
  }
  if (paper.has("found"))
    context.file.paper.found = context.text(paper, "found", "what the claims show, in a sentence");
  if (paper.has("question")) {
    context.file.paper.question = context.text(paper, "question", "what the paper asks, in a few sentences");
  }
  context.file.paper.origin = context.origin(paper, Origin::printed);
  for (const PlacedText* open : paper.strings("open")) context.file.paper.open.push_back(open->text());
  for (const PlacedText* scene : paper.strings("scenes")) context.file.paper.scenes.push_back(scene->text());
  if (const TomlValue* headings = paper.table("headings")) read_headings(*headings, context);
  if (const TomlValue* equations = paper.table("equations")) {
    std::vector<std::string_view> numbers;
    for (const TomlEntry& entry : equations->entries) numbers.push_back(entry.key);
    const TableReader lines(*equations, "[paper.equations]", numbers, context.mistakes);
    for (const TomlEntry& entry : equations->entries) {
      context.file.paper.equations.push_back({entry.key, context.line(lines, entry.key, true)});
    }
  }
}

void read_unchecked(const TableReader& root, Context& context) {
  static constexpr std::array<std::string_view, 4> keys{"id", "line", "statement", "why"};
  for (const TomlValue* value : root.tables("unchecked")) {
    const TableReader table(*value, "[[unchecked]]", keys, context.mistakes);
    Unchecked unchecked;
    unchecked.id = context.text(table, "id", "an id such as \"R1.1\"");
    unchecked.line = context.line(table, "line", true);
    unchecked.statement = context.text(table, "statement", "what the paper says");
    unchecked.why = context.text(table, "why", "why it cannot be judged");
    context.file.unchecked.push_back(std::move(unchecked));
  }
}

}  // namespace

}  // namespace claims_reader

ClaimsFile parse_claims(std::string_view text, const std::string& file) {
  ClaimsFile claims;
  claims.file = file;
  Mistakes mistakes(file);
  if (const auto document = parse_toml(text, mistakes)) {
    static constexpr std::array<std::string_view, 5> keys{"schema", "paper", "setting", "claim", "unchecked"};
    const TableReader root(*document, "", keys, mistakes);
    claims_reader::Context context(claims, mistakes);
    constexpr std::string_view schema = "slipproof/claims/1";
    if (context.text(root, "schema", "\"slipproof/claims/1\"") != schema && root.has("schema")) {
      root.refuse("schema", "expected \"slipproof/claims/1\"");
    }
    claims_reader::read_paper(root, context);
    claims_reader::read_settings(root, context);
    claims_reader::read_claims(root, context);
    claims_reader::read_unchecked(root, context);
    claims_reader::check_uses(context);
  }
  mistakes.refuse_if_any();
  return claims;
}

ClaimsFile read_claims(const std::filesystem::path& path) {
  return parse_claims(read_text_file(path), path.string());
}

}  // namespace slipproof
