// From a line of text to a record.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "records/certify/certify.hpp"
#include "records/certify/csv_line.hpp"
#include "records/certify/lane_judge.hpp"

namespace slipproof {

/// What a CSV header says: a field, the mode or the kind of force for each column. Immutable once made; shared by
/// threads.
class RecordReader {
 public:
  /// `header` is the first line of CSV. Throws InputError at line 1.
  RecordReader(const CertifyOptions& options, std::string_view header);
  /// Throws BrokenRecord.
  Record read(std::string_view line) const { return csv_ ? read_csv({line}) : read_json(line); }

  /// The lanes that judge usual lines of CSV, if any can.
  std::optional<LaneJudge> lanes() const;
  /// What is the same for all lines of CSV.
  void fill_constants(LaneRecords& records) const;
  UsualLines usual_lines() const { return UsualLines(columns_); }
  /// A line of CSV in which every number is a finite decimal and every text is known goes into the next row of the
  /// records. Lines before, of the same `lines`, are in the rows before. False for any other line, which read() takes.
  bool read_usual(const CsvLine& line, UsualLines& lines, LaneRecords& records) const;

 private:
  friend class JsonRecord;
  static constexpr int mode_column = -1, kind_column = -2;

  void read_header(std::string_view header);
  Record read_csv(const CsvLine& line) const;
  Record read_json(std::string_view line) const;
  void put(Record& record, int column, std::string_view text, std::size_t place) const;

  const CertifyOptions& options_;
  bool csv_;
  Record base_;
  std::uint32_t complete_ = 0;  ///< the fields of a CSV line without empty cells
  std::uint32_t own_ = 0;       ///< those that have columns
  std::vector<int> columns_;
};

}  // namespace slipproof
