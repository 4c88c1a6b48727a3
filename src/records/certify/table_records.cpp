#include "records/certify/table_records.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <mutex>

#include "records/certify/columns.hpp"
#include "records/certify/judged.hpp"
#include "records/certify/mechanism_judge.hpp"
#include "records/certify/mechanism_reader.hpp"

namespace slipproof {

namespace {

constexpr int mode_of_table = -1, kind_of_table = -2;

/// What each column of the table is: the number of a field, a negative one for mode and kind, or ignored_column.
/// find(name) is as for read_header(). Adds to the mistakes.
template <class Find>
std::vector<int> bind_columns(const Table& table, const CertifyOptions& options, bool mode_codes, Mistakes& mistakes,
                              const Find& find) {
  std::vector<int> bound;
  for (const TableColumn& column : table.columns) {
    const std::optional<int> found = find(column.name);
    const std::string where = "the column " + in_quotes(column.name);
    const bool known = found.has_value(), twice = known && std::ranges::find(bound, *found) != bound.end();
    if (!known && !options.ignore_unknown) {
      mistakes.add({}, "found " + where + ", expected a parameter or a part of the answer");
    }
    if (twice) mistakes.add({}, "found " + where + " twice, expected it once");
    const CellType& type = column.type;
    const bool fits = !known || (*found >= 0 ? type.is_number() : type.is_text() || (mode_codes && type.is_integer()));
    if (!fits) {
      mistakes.add({}, where + ": found the type " + in_quotes(type.name) + ", expected " +
                           (*found >= 0  ? "numbers: f8 or f4, integers of 1 to 8 bytes"
                            : mode_codes ? "texts of fixed length (S or U) or integers"
                                         : "texts of fixed length (S or U)"));
    }
    bound.push_back(found.value_or(ignored_column));
  }
  return bound;
}

/// The values of one column of texts or codes, which are few: each is looked at once.
template <class Value>
class CellCache {
 public:
  template <class Make>
  const Value& at(const char* cell, std::size_t size, const Make& make) {
    const std::string_view bytes(cell, size);
    if (last_ != known_.end() && last_->first == bytes) return last_->second;
    last_ = known_.find(bytes);
    if (last_ != known_.end()) return last_->second;
    if (known_.size() >= most) known_.clear();
    return (last_ = known_.emplace(std::string(bytes), make()).first)->second;
  }

 private:
  static constexpr std::size_t most = 64;
  std::map<std::string, Value, std::less<>> known_;
  typename std::map<std::string, Value, std::less<>>::iterator last_ = known_.end();
};

/// A code, or why there is none.
struct CellCode {
  std::uint8_t code = 0;
  std::string mistake;
};

CellCode mode_code(const CellType& type, const char* cell) {
  if (type.is_integer()) {
    const std::int64_t code = integer_at(type, cell);
    if (code == -1) return {no_mode, {}};
    if (code >= 0 && code < 16) return {static_cast<std::uint8_t>(code), {}};
    return {no_mode, "mode: found " + std::to_string(code) + ", expected 0 to 15, or -1 for none"};
  }
  const std::string text = text_at(type, cell);
  if (text.empty()) return {no_mode, {}};
  if (const auto mode = parse_mode(text)) return {static_cast<std::uint8_t>(mode->index()), {}};
  return {no_mode, "found the mode " + in_quotes(text) + ", expected one like stick/slip+"};
}

CellCode kind_code(const CellType& type, const char* cell) {
  if (type.is_integer()) {
    const std::int64_t code = integer_at(type, cell);
    if (code == 0 || code == 1) return {static_cast<std::uint8_t>(code), {}};
    return {0, "kind: found " + std::to_string(code) + ", expected 0 (internal) or 1 (external)"};
  }
  const std::string text = text_at(type, cell);
  if (const auto kind = parse_force_kind(text)) return {static_cast<std::uint8_t>(*kind == ForceKind::external), {}};
  return {0, "found the kind " + in_quotes(text) + ", expected internal or external"};
}

/// Judges the bicycles of a table.
class BicycleTable {
 public:
  BicycleTable(const Table& table, const CertifyOptions& options) : table_(table), options_(options) {
    Mistakes mistakes(options.file);
    bound_ = bind_columns(table, options, true, mistakes, [](std::string_view name) -> std::optional<int> {
      if (const auto field = parse_field(name)) return static_cast<int>(index(*field));
      if (name == "mode") return mode_of_table;
      return name == "kind" ? std::optional(kind_of_table) : std::nullopt;
    });
    std::uint32_t given = 0;
    for (const int column : bound_) given |= column >= 0 ? std::uint32_t{1} << static_cast<unsigned>(column) : 0;
    Record base = options.scene ? to_record(*options.scene) : Record();
    if (const std::string reason = incomplete(over_scene(base, given)); !reason.empty()) mistakes.add({}, reason);
    mistakes.refuse_if_any();
    columns_.judge = options.judge;
    columns_.scene = options.scene;
  }

  Judged judge(const TableBlock& block) const {
    Codes codes;
    RecordColumns columns{.records = block.rows};
    std::vector<std::vector<double>> numbers;
    for (std::size_t k = 0; k < bound_.size(); ++k) add_column(k, block, columns, numbers, codes);
    Judged result;
    const ColumnsJudge judge(columns, columns_);
    judge.each(0, block.rows, [&](std::size_t i, const RecordJudgement& judgement) {
      const std::uint64_t record = block.first + i + 1;
      if (result.broken) return;
      const auto mistake = codes.mistakes.find(i);
      if (mistake == codes.mistakes.end()) {
        result.add(record, judgement, false, options_);
        return;
      }
      RecordJudgement invalid;
      if (result.take({0, mistake->second}, 0, record, invalid, options_)) result.add(record, invalid, true, options_);
    });
    return result;
  }

 private:
  struct Codes {
    std::vector<std::uint8_t> modes, kinds;
    std::map<std::size_t, std::string> mistakes;  ///< the first of each row that has one
  };

  void add_column(std::size_t k, const TableBlock& block, RecordColumns& columns,
                  std::vector<std::vector<double>>& numbers, Codes& codes) const {
    const TableColumn& column = table_.columns[k];
    if (bound_[k] == ignored_column) return;
    const char* const cells = table_.cells(block, column);
    const std::size_t stride = table_.stride(column);
    if (bound_[k] == mode_of_table) {
      columns.modes = read_codes(column.type, cells, stride, block.rows, mode_code, codes.modes, codes.mistakes);
    } else if (bound_[k] == kind_of_table) {
      columns.kinds = read_codes(column.type, cells, stride, block.rows, kind_code, codes.kinds, codes.mistakes);
    } else {
      NumberColumn& result = columns.numbers[static_cast<std::size_t>(bound_[k])];
      result = {cells, static_cast<std::ptrdiff_t>(stride)};
      if (column.type.is_native()) return;
      std::vector<double>& values = numbers.emplace_back(stride == 0 ? 1 : block.rows);
      read_numbers(column.type, cells, stride, values.size(), values.data());
      result = {values.data(), stride == 0 ? 0 : static_cast<std::ptrdiff_t>(sizeof(double))};
    }
  }

  template <class Read>
  static CodeColumn read_codes(const CellType& type, const char* cells, std::size_t stride, std::size_t rows,
                               const Read& read, std::vector<std::uint8_t>& codes,
                               std::map<std::size_t, std::string>& mistakes) {
    CellCache<CellCode> cache;
    codes.resize(rows);
    for (std::size_t i = 0; i < rows; ++i) {
      const char* const cell = cells + i * stride;
      const CellCode& found = cache.at(cell, type.size, [&] { return read(type, cell); });
      codes[i] = found.code;
      if (!found.mistake.empty()) mistakes.emplace(i, found.mistake);
    }
    return {codes.data(), 1};
  }

  const Table& table_;
  const CertifyOptions& options_;
  ColumnsOptions columns_;
  std::vector<int> bound_;
};

/// Judges the records of a mechanism.
class MechanismTable {
 public:
  MechanismTable(const Table& table, const CertifyOptions& options)
      : table_(table), options_(options), fields_(options.mechanism->mechanism), judge_(*options.mechanism, fields_) {
    Mistakes mistakes(options.file);
    bound_ = bind_columns(table, options, false, mistakes, [this](std::string_view name) -> std::optional<int> {
      if (const auto field = fields_.find(name)) return static_cast<int>(*field);
      return name == "mode" ? std::optional(mode_of_table) : std::nullopt;
    });
    MechanismRecord all;
    all.clear(fields_.size());
    for (const int column : bound_) {
      if (column >= 0) all.present[static_cast<std::size_t>(column)] = true;
    }
    const std::string reason = incomplete(all, fields_, *options.mechanism);
    if (!reason.empty()) mistakes.add({}, reason);
    mistakes.refuse_if_any();
  }

  Judged judge(const TableBlock& block) const {
    JudgedRecords records(options_);
    MechanismBlock judging(judge_, options_.judge);
    MechanismRecord record;
    const auto finish = [&] { judging.finish(); };
    const auto judge_row = [&](std::size_t row, RecordJudgement& judgement) {
      read(block, row, record);
      if (record.not_finite) {
        judgement = invalid_judgement(record.not_finite->reason);
      } else {
        judging.add(record, judgement);
      }
    };
    for (std::size_t row = 0; row < block.rows; ++row) {
      const auto judge = [&](RecordJudgement& to) { judge_row(row, to); };
      if (!records.add(block.first + row + 1, 0, judge, finish)) break;
    }
    return records.result(finish);
  }

 private:
  void read(const TableBlock& block, std::size_t row, MechanismRecord& record) const {
    record.clear(fields_.size());
    for (std::size_t k = 0; k < bound_.size(); ++k) {
      if (bound_[k] == ignored_column) continue;
      const TableColumn& column = table_.columns[k];
      const char* const cell = table_.cells(block, column) + row * table_.stride(column);
      if (bound_[k] == mode_of_table) {
        read_mode(text_at(column.type, cell), record);
        continue;
      }
      const auto field = static_cast<std::size_t>(bound_[k]);
      const double value = number_at(column.type, cell);
      record.set(field, value);
      if (!record.not_finite) record.not_finite = not_finite(fields_.name(field), value, 0);
    }
  }

  void read_mode(const std::string& text, MechanismRecord& record) const {
    if (text.empty()) return;
    record.mode = fields_.find_mode(text);
    if (record.mode != nullptr) return;
    throw BrokenRecord{0, "found the mode " + in_quotes(text) + ", expected one like " + fields_.some_mode()};
  }

  const Table& table_;
  const CertifyOptions& options_;
  MechanismFields fields_;
  MechanismJudge judge_;
  std::vector<int> bound_;
};

template <class Judge>
CertifySummary certify_rows(Table& table, const LineSink& output, const CertifyOptions& options,
                            const Progress& progress) {
  const Judge judge(table, options);
  table.skip(std::max<std::uint64_t>(options.first_record, 1) - 1);
  return judge_in_order<TableBlock>(
      options, output, progress, [&](TableBlock& block) { return table.next(block); },
      [&](const TableBlock& block) { return judge.judge(block); });
}

}  // namespace

CertifySummary certify(Table table, const LineSink& output, const CertifyOptions& options, const Progress& progress) {
  if (options.mechanism) return certify_rows<MechanismTable>(table, output, options, progress);
  return certify_rows<BicycleTable>(table, output, options, progress);
}

}  // namespace slipproof
