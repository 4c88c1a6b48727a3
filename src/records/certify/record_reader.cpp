#include "records/certify/record_reader.hpp"

#include <utility>

#include "records/certify/json_object.hpp"

namespace slipproof {

RecordReader::RecordReader(const CertifyOptions& options, std::string_view header)
    : options_(options), csv_(options.format != RecordFormat::json_lines) {
  if (options.scene) base_ = to_record(*options.scene);
  if (csv_) read_header(header);
}

void RecordReader::read_header(std::string_view header) {
  Mistakes mistakes(options_.file);
  columns_ = slipproof::read_header(header, options_.ignore_unknown, mistakes, [](std::string_view name) {
    if (const auto field = parse_field(name)) return std::optional(static_cast<int>(index(*field)));
    if (name == "mode") return std::optional(mode_column);
    return name == "kind" ? std::optional(kind_column) : std::nullopt;
  });
  for (const int column : columns_) {
    if (column >= 0) own_ |= bit(static_cast<Field>(column));
  }
  complete_ = over_scene(base_, own_);
  if (const std::string reason = incomplete(complete_); !reason.empty()) mistakes.add({1, 1}, reason);
  mistakes.refuse_if_any();
}

void RecordReader::put(Record& record, int column, std::string_view text, std::size_t place) const {
  if (column == mode_column) {
    if (text.empty()) return;
    record.mode = parse_mode(text);
    if (!record.mode)
      throw BrokenRecord{place, "found the mode " + in_quotes(text) + ", expected one like stick/slip+"};
    return;
  }
  if (column == kind_column) {
    const auto kind = parse_force_kind(text);
    if (!kind) throw BrokenRecord{place, "found the kind " + in_quotes(text) + ", expected internal or external"};
    record.force_kind = *kind;
    return;
  }
  const auto field = static_cast<Field>(column);
  const CellNumber number = read_number(text, field_names[index(field)], place, options_.decimal_exact);
  if (number.exact) {
    record.set(field, *number.exact);
  } else {
    record.set(field, number.nearest);
  }
  if (!record.not_finite) record.not_finite = slipproof::not_finite(field_names[index(field)], record[field], place);
}

std::optional<LaneJudge> RecordReader::lanes() const {
  if (!csv_ || options_.decimal_exact) return std::nullopt;
  const LaneJudge lanes(complete_, own_, base_);
  return lanes.able() ? std::optional(lanes) : std::nullopt;
}

void RecordReader::fill_constants(LaneRecords& records) const {
  for (std::size_t k = 0; k < field_count; ++k) records.numbers[k].fill(base_.values[k]);
  records.modes.fill(no_mode);
  records.kinds.fill(base_.force_kind);
}

bool RecordReader::read_usual(const CsvLine& line, UsualLines& lines, LaneRecords& records) const {
  const std::size_t row = records.count;
  const auto numbers = [&](int column) { return records.numbers[static_cast<std::size_t>(column)].data(); };
  const auto set = [&](int column, double value) { numbers(column)[row] = value; };
  const auto put = [&](int column, std::string_view text) {
    if (column == mode_column) {
      const auto mode = parse_mode(text);
      if (mode) records.modes[row] = static_cast<std::uint8_t>(mode->index());
      return mode.has_value();
    }
    const auto kind = parse_force_kind(text);
    if (kind) records.kinds[row] = *kind;
    return kind.has_value();
  };
  const auto repeat = [&](int column) {
    if (column >= 0) {
      numbers(column)[row] = numbers(column)[row - 1];
    } else if (column == mode_column) {
      records.modes[row] = records.modes[row - 1];
    } else if (column == kind_column) {
      records.kinds[row] = records.kinds[row - 1];
    }
  };
  return lines.read(line, set, put, repeat);
}

Record RecordReader::read_csv(const CsvLine& line) const {
  Record record = fresh_record(base_);
  read_cells(
      line.line, columns_, options_.decimal_exact,
      [&](int column, double value) { record.set(static_cast<Field>(column), value); },
      [&](int column, std::string_view text, std::size_t place) { put(record, column, text, place); });
  // An empty cell leaves what the scene says, and may leave nothing.
  if (record.present == complete_) return record;
  if (const std::string reason = incomplete(record.present); !reason.empty()) throw BrokenRecord{1, reason};
  return record;
}

/// What stands under the keys of a line.
class JsonRecord {
 public:
  explicit JsonRecord(const RecordReader& reader) : reader_(reader), record_(fresh_record(reader.base_)) {}
  Record take() { return std::move(record_); }

  int key(const std::string& name) {
    if (const auto field = parse_field(name)) {
      if ((seen_ & bit(*field)) != 0) throw BrokenRecord{0, "found " + in_quotes(name) + " twice, expected it once"};
      seen_ |= bit(*field);
      // Over the scene's own forms only: two forms in one record are a mistake, which incomplete() reports.
      const auto here = record_.present & seen_;
      record_.replace_other_forms(*field);
      record_.present |= here;
      return static_cast<int>(index(*field));
    }
    if (name == "mode") return RecordReader::mode_column;
    if (name == "kind") return RecordReader::kind_column;
    if (reader_.options_.ignore_unknown) return ignored_column;
    throw BrokenRecord{0, "found the key " + in_quotes(name) + ", expected a parameter or a part of the answer"};
  }
  void put(int column, std::string_view text, std::size_t place) { reader_.put(record_, column, text, place); }

 private:
  const RecordReader& reader_;
  Record record_;
  std::uint32_t seen_ = 0;
};

Record RecordReader::read_json(std::string_view line) const {
  JsonRecord json(*this);
  JsonObject<JsonRecord>::read(line, json);
  Record record = json.take();
  if (const std::string reason = incomplete(record.present); !reason.empty()) throw BrokenRecord{0, reason};
  return record;
}

}  // namespace slipproof
