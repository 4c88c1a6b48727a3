#include "records/certify/mechanism_reader.hpp"

#include <utility>

#include "records/certify/csv_line.hpp"
#include "records/certify/json_object.hpp"

namespace slipproof {

MechanismReader::MechanismReader(const CertifyOptions& options, std::string_view header)
    : options_(options), fields_(options.mechanism->mechanism), csv_(options.format != RecordFormat::json_lines) {
  if (!csv_) return;
  Mistakes mistakes(options.file);
  columns_ =
      read_header(header, options.ignore_unknown, mistakes, [this](std::string_view name) { return find(name); });
  MechanismRecord all;
  all.clear(fields_.size());
  for (const int column : columns_) {
    if (column >= 0) all.present[static_cast<std::size_t>(column)] = true;
  }
  complete_ = all.present;
  if (const std::string reason = incomplete(all, fields_, *options.mechanism); !reason.empty()) {
    mistakes.add({1, 1}, reason);
  }
  mistakes.refuse_if_any();
}

std::optional<int> MechanismReader::find(std::string_view name) const {
  if (const auto field = fields_.find(name)) return static_cast<int>(*field);
  return name == "mode" ? std::optional(mode_column) : std::nullopt;
}

void MechanismReader::put(MechanismRecord& record, int column, std::string_view text, std::size_t place) const {
  if (column == mode_column) {
    if (text.empty()) return;
    record.mode = fields_.find_mode(text);
    if (record.mode != nullptr) return;
    throw BrokenRecord{place, "found the mode " + in_quotes(text) + ", expected one like " + fields_.some_mode()};
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

/// What stands under the keys of a line.
class MechanismJson {
 public:
  MechanismJson(const MechanismReader& reader, MechanismRecord& record) : reader_(reader), record_(record) {}

  int key(const std::string& name) {
    const auto column = reader_.find(name);
    if (column && *column >= 0 && record_.present[static_cast<std::size_t>(*column)]) {
      throw BrokenRecord{0, "found " + in_quotes(name) + " twice, expected it once"};
    }
    if (column) return *column;
    if (reader_.options_.ignore_unknown) return ignored_column;
    throw BrokenRecord{0, "found the key " + in_quotes(name) + ", expected a parameter or a part of the answer"};
  }
  void put(int column, std::string_view text, std::size_t place) { reader_.put(record_, column, text, place); }

 private:
  const MechanismReader& reader_;
  MechanismRecord& record_;
};

void MechanismReader::read(std::string_view line, MechanismRecord& record) const {
  record.clear(fields_.size());
  if (csv_) {
    read_cells(
        line, columns_, options_.decimal_exact,
        [&](int column, double value) { record.set(static_cast<std::size_t>(column), value); },
        [&](int column, std::string_view text, std::size_t place) { put(record, column, text, place); });
    if (record.present == complete_) return;
  } else {
    MechanismJson json(*this, record);
    JsonObject<MechanismJson>::read(line, json);
  }
  if (const std::string reason = incomplete(record, fields_, *options_.mechanism); !reason.empty()) {
    throw BrokenRecord{csv_ ? std::size_t{1} : 0, reason};
  }
}

}  // namespace slipproof
