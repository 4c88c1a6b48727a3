#include "records/certify/table_records.hpp"

#include <algorithm>
#include <cstring>
#include <map>

#include "records/certify/columns.hpp"
#include "records/certify/judged.hpp"
#include "records/reading/record_reader.hpp"
#include "records/record/bicycle_records.hpp"

namespace slipproof {

namespace {

/// The meaning of each column of the table: the number of a field, a negative number for mode and kind, or
/// ignored_column. Adds to the mistakes.
std::vector<int> bind_columns(const Table& table, const RecordFields& fields, const CertifyOptions& options,
                              Mistakes& mistakes) {
  std::vector<int> bound;
  for (const TableColumn& column : table.columns) {
    const std::optional<int> found = find_column(fields, column.name);
    const std::string where = "the column " + in_quotes(column.name);
    const bool known = found.has_value(), twice = known && std::ranges::find(bound, *found) != bound.end();
    if (!known && !options.ignore_unknown) {
      mistakes.add({}, "found " + where + ", expected a parameter or a part of the answer");
    }
    if (twice) mistakes.add({}, "found " + where + " twice, expected it once");
    const CellType& type = column.type;
    const bool fits = !known || (*found >= 0 ? type.is_number() : type.is_text() || type.is_integer());
    if (!fits) {
      mistakes.add({}, where + ": found the type " + in_quotes(type.name) + ", expected " +
                           (*found >= 0 ? "numbers: f8 or f4, integers of 1 to 8 bytes"
                                        : "texts of fixed length (S or U) or integers"));
    }
    bound.push_back(found.value_or(ignored_column));
  }
  return bound;
}

/// The values of a column of texts or codes. There are few different ones; each is looked up once.
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

/// A code, or the reason why there is none.
struct CellCode {
  std::uint16_t code = 0;
  std::string mistake;
};

/// read() returns a code, or throws BrokenRecord.
template <class Read>
CellCode code_of(const Read& read) {
  try {
    return {static_cast<std::uint16_t>(read()), {}};
  } catch (const BrokenRecord& broken) {
    return {no_mode, broken.message};
  }
}

CellCode mode_code(const RecordFields& fields, const CellType& type, const char* cell) {
  if (type.is_integer()) {
    const std::int64_t code = integer_at(type, cell), modes = static_cast<std::int64_t>(fields.modes().size());
    if (code == -1) return {no_mode, {}};
    if (!fields.modes().has_all()) return {no_mode, "mode: found a number, expected the mode's name, or -1 for none"};
    if (code >= 0 && code < modes) return {static_cast<std::uint16_t>(code), {}};
    return {no_mode, "mode: found " + std::to_string(code) + ", expected 0 to " + std::to_string(modes - 1) +
                         ", or -1 for none"};
  }
  const std::string text = text_at(type, cell);
  return text.empty() ? CellCode{no_mode, {}} : code_of([&] { return read_mode(fields, text, 0); });
}

CellCode word_code(const RecordFields& fields, const CellType& type, const char* cell) {
  if (!type.is_integer()) return code_of([&] { return read_word(fields, text_at(type, cell), 0); });
  const std::int64_t code = integer_at(type, cell);
  const auto& words = fields.word()->words;
  if (code >= 0 && code < static_cast<std::int64_t>(words.size())) return {static_cast<std::uint16_t>(code), {}};
  std::string expected;
  for (std::size_t i = 0; i < words.size(); ++i) {
    expected += (i == 0 ? "" : " or ") + std::to_string(i) + " (" + words[i] + ")";
  }
  return {0, fields.word()->name + ": found " + std::to_string(code) + ", expected " + expected};
}

/// Judges the records of a table.
class TableJudge {
 public:
  TableJudge(const Table& table, const CertifyOptions& options)
      : table_(table),
        options_(options),
        judge_(options.mechanism ? *options.mechanism : bicycle_records(), options.judge) {
    Mistakes mistakes(options.file);
    bound_ = bind_columns(table, judge_.fields(), options, mistakes);
    fields_of_columns(bound_, judge_.fields(), judge_.certified(), {}, mistakes);
    mistakes.refuse_if_any();
  }

  Judged judge(const TableBlock& block) const {
    InMemory memory;
    RecordColumns columns(judge_.fields(), block.rows);
    for (std::size_t k = 0; k < bound_.size(); ++k) add_column(k, block, columns, memory);
    Judged result;
    const ColumnsJudge judge(columns, judge_);
    judge.each(0, block.rows, [&](std::size_t i, const RecordJudgement& judgement) {
      const std::uint64_t record = block.first + i + 1;
      if (result.broken) return;
      const auto mistake = memory.mistakes.find(i);
      if (mistake == memory.mistakes.end()) {
        result.add(record, judgement, false, options_);
        return;
      }
      RecordJudgement invalid;
      if (result.take({0, mistake->second}, 0, record, invalid, options_)) result.add(record, invalid, true, options_);
    });
    return result;
  }

 private:
  /// Columns that had to be converted, in place of those in the table.
  struct InMemory {
    std::vector<std::uint16_t> modes;
    std::vector<std::vector<double>> numbers;
    std::map<std::size_t, std::string> mistakes;  ///< the first mistake of each row that has one
  };

  void add_column(std::size_t k, const TableBlock& block, RecordColumns& columns, InMemory& memory) const {
    const TableColumn& column = table_.columns[k];
    if (bound_[k] == ignored_column) return;
    const char* const cells = Table::cells(block, column);
    const std::size_t stride = table_.stride(column);
    const auto in_memory = [&](std::size_t field) -> std::vector<double>& {
      std::vector<double>& values = memory.numbers.emplace_back(block.rows);
      columns.numbers[field] = {values.data(), static_cast<std::ptrdiff_t>(sizeof(double))};
      return values;
    };
    if (bound_[k] == mode_column) {
      memory.modes.resize(block.rows);
      read_codes(column.type, cells, stride, mode_code, memory.modes, memory);
      columns.modes = std::span<const std::uint16_t>(memory.modes);
    } else if (bound_[k] == word_column) {
      read_codes(column.type, cells, stride, word_code, in_memory(judge_.fields().word_field()), memory);
    } else {
      const auto field = static_cast<std::size_t>(bound_[k]);
      columns.numbers[field] = {cells, static_cast<std::ptrdiff_t>(stride)};
      if (column.type.is_native()) return;
      std::vector<double>& values = in_memory(field);
      read_numbers(column.type, cells, stride, values.size(), values.data());
    }
  }

  template <class Read, class T>
  void read_codes(const CellType& type, const char* cells, std::size_t stride, const Read& read, std::vector<T>& codes,
                  InMemory& memory) const {
    CellCache<CellCode> cache;
    for (std::size_t i = 0; i < codes.size(); ++i) {
      const char* const cell = cells + i * stride;
      const CellCode& found = cache.at(cell, type.size, [&] { return read(judge_.fields(), type, cell); });
      codes[i] = static_cast<T>(found.code);
      if (!found.mistake.empty()) memory.mistakes.emplace(i, found.mistake);
    }
  }

  const Table& table_;
  const CertifyOptions& options_;
  RecordJudge judge_;
  std::vector<int> bound_;
};

}  // namespace

CertifySummary certify(Table table, const LineSink& output, const CertifyOptions& options, const Progress& progress) {
  const TableJudge judge(table, options);
  table.skip(std::max<std::uint64_t>(options.first_record, 1) - 1);
  return judge_in_order<TableBlock>(
      options, output, progress, [&](TableBlock& block) { return table.next(block); },
      [&](const TableBlock& block) { return judge.judge(block); });
}

}  // namespace slipproof
