#include "records/reading/record_reader.hpp"

#include <algorithm>
#include <utility>

#include "base/files/json_tree.hpp"
#include "base/files/words.hpp"

namespace slipproof {

std::optional<int> find_column(const RecordFields& fields, std::string_view name) {
  if (const auto field = fields.find(name)) return static_cast<int>(*field);
  if (name == "mode" && fields.has_modes()) return mode_column;
  return fields.word() && name == fields.word()->name ? std::optional(word_column) : std::nullopt;
}

std::vector<bool> fields_of_columns(const std::vector<int>& columns, const RecordFields& fields,
                                    const CertifiedMechanism& certified, Place place, Mistakes& mistakes) {
  std::vector<bool> present(fields.size(), false);
  for (const int column : columns) {
    if (column >= 0) present[static_cast<std::size_t>(column)] = true;
  }
  if (std::ranges::find(columns, word_column) != columns.end()) {
    if (present[fields.word_field()]) {
      mistakes.add(place, "found " + fields.word()->name + " together with " + fields.word()->parameter +
                              ", expected only one of them");
    }
    present[fields.word_field()] = true;
  }
  if (const std::string reason = incomplete(present, fields, certified); !reason.empty()) mistakes.add(place, reason);
  return present;
}

std::uint16_t read_mode(const RecordFields& fields, std::string_view text, std::size_t place) {
  if (const auto mode = fields.find_mode(text)) return *mode;
  throw BrokenRecord{place, "found the mode " + in_quotes(text) + ", expected one like " + fields.modes().example()};
}

std::size_t read_word(const RecordFields& fields, std::string_view text, std::size_t place) {
  if (const auto value = fields.find_word(text)) return *value;
  std::string expected;
  for (const std::string& word : fields.word()->words) expected += (expected.empty() ? "" : " or ") + word;
  throw BrokenRecord{place, "found the " + fields.word()->name + " " + in_quotes(text) + ", expected " + expected};
}

RecordReader::RecordReader(const CertifyOptions& options, const CertifiedMechanism& certified,
                           const RecordFields& fields, std::string_view header)
    : options_(options), certified_(certified), fields_(fields), csv_(options.format != RecordFormat::json_lines) {
  if (!csv_) return;
  Mistakes mistakes(options.file);
  columns_ = read_header(header, options.ignore_unknown, mistakes,
                         [&](std::string_view name) { return find_column(fields, name); });
  complete_ = fields_of_columns(columns_, fields, certified, {1, 1}, mistakes);
  mistakes.refuse_if_any();
}

void RecordReader::put(Record& record, int column, std::string_view text, std::size_t place) const {
  if (column == mode_column) {
    if (!text.empty()) record.mode = read_mode(fields_, text, place);
    return;
  }
  if (column == word_column) {
    record.set(fields_.word_field(), static_cast<double>(read_word(fields_, text, place)));
    return;
  }
  const auto field = static_cast<std::size_t>(column);
  CellNumber number = read_number(text, fields_.name(field), place, options_.decimal_exact);
  if (!record.not_finite) record.not_finite = not_finite(fields_.name(field), number.nearest, place);
  if (number.exact) {
    record.set(field, std::move(*number.exact));
  } else {
    record.set(field, number.nearest);
  }
}

bool RecordReader::read_plain(const CsvLine& line, PlainLines& lines, RecordBlock& block) const {
  const std::size_t row = block.size();
  const auto numbers = [&](std::size_t field) { return block.numbers(field); };
  const auto set = [&](int column, double value) { numbers(static_cast<std::size_t>(column))[row] = value; };
  const auto put = [&](int column, std::string_view text) {
    const auto mode = column == mode_column ? fields_.find_mode(text) : std::nullopt;
    const auto word = column == word_column ? fields_.find_word(text) : std::nullopt;
    if (mode) block.mode(row) = *mode;
    if (word) numbers(fields_.word_field())[row] = static_cast<double>(*word);
    return mode || word;
  };
  const auto repeat = [&](int column) {
    if (column == mode_column) {
      block.mode(row) = block.mode(row - 1);
    } else if (column != ignored_column) {
      double* const of = numbers(column == word_column ? fields_.word_field() : static_cast<std::size_t>(column));
      of[row] = of[row - 1];
    }
  };
  block.mode(row) = no_mode;
  if (!lines.read(line, set, put, repeat)) return false;
  block.add();
  return true;
}

void RecordReader::read(std::string_view line, Record& record) const {
  record.clear(fields_.size());
  if (csv_) {
    read_cells(
        line, columns_, options_.decimal_exact,
        [&](int column, double value) { record.set(static_cast<std::size_t>(column), value); },
        [&](int column, std::string_view text, std::size_t place) { put(record, column, text, place); });
    if (record.present == complete_) return;
  } else {
    read_json(line, record);
  }
  if (const std::string reason = incomplete(record.present, fields_, certified_); !reason.empty()) {
    throw BrokenRecord{csv_ ? std::size_t{1} : 0, reason};
  }
}

void RecordReader::read_json(std::string_view line, Record& record) const {
  JsonTree json;
  try {
    json = read_json_tree(line);
  } catch (const FormatStop& stop) {
    throw BrokenRecord{stop.position + 1, stop.message};
  }
  for (std::size_t k = 0; k < json.root.keys.size(); ++k) {
    const std::string_view key = json.root.keys[k];
    const JsonNode& value = json.root.items[k];
    const auto column = find_column(fields_, key);
    if (!column && options_.ignore_unknown) continue;
    if (!column) {
      throw BrokenRecord{0, "found the key " + in_quotes(key) + ", expected a parameter or a part of the answer"};
    }
    const bool is_word = *column == word_column;
    if (*column != mode_column && record.present[is_word ? fields_.word_field() : static_cast<std::size_t>(*column)]) {
      throw BrokenRecord{0, "found " + in_quotes(key) + " twice, expected it once"};
    }
    if (value.kind == JsonNode::Kind::null) continue;
    const bool is_number = value.kind == JsonNode::Kind::number;
    if (!is_number && value.kind != JsonNode::Kind::text) {
      throw BrokenRecord{0, "found " + std::string(name(value.kind)) + ", expected an object of numbers"};
    }
    put(record, *column, value.text, is_number ? static_cast<std::size_t>(value.text.data() - line.data()) + 1 : 0);
  }
}

}  // namespace slipproof
