// From a line of text to a record.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "certify/certify.hpp"

namespace slipproof {

/// A line that cannot be read: its column (from 1; 0: no place) and what was found and expected.
struct BrokenRecord {
  std::size_t column;
  std::string message;
};

/// "line 3, column 25: ", or without a column if it is 0.
std::string place_text(std::uint64_t line, std::size_t column);

/// Neither a fraction nor hexadecimal: what `--decimal` is about.
bool is_decimal(std::string_view text);

/// What a CSV header says: a field, the mode or the kind of force for each column. Immutable once made; shared by
/// threads.
class RecordReader {
 public:
  /// `header` is the first line of CSV. Throws InputError at line 1.
  RecordReader(const CertifyOptions& options, std::string_view header);
  /// Throws BrokenRecord.
  Record read(std::string_view line) const { return csv_ ? read_csv(line) : read_json(line); }

 private:
  friend class JsonRecord;
  static constexpr int mode_column = -1, kind_column = -2, ignored_column = -3;

  void read_header(std::string_view header);
  Record fresh() const;
  Record read_csv(std::string_view line) const;
  Record read_json(std::string_view line) const;
  void put(Record& record, int column, std::string_view text, std::size_t place) const;
  void put_number(Record& record, Field field, std::string_view text, std::size_t place) const;

  const CertifyOptions& options_;
  bool csv_;
  Record base_;
  std::uint32_t complete_ = 0;  ///< the fields of a CSV line without empty cells
  std::vector<int> columns_;
};

}  // namespace slipproof
