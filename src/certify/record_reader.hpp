// From a line of text to a record.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "certify/cells.hpp"
#include "certify/certify.hpp"

namespace slipproof {

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
  static constexpr int mode_column = -1, kind_column = -2;

  void read_header(std::string_view header);
  Record read_csv(std::string_view line) const;
  Record read_json(std::string_view line) const;
  void put(Record& record, int column, std::string_view text, std::size_t place) const;

  const CertifyOptions& options_;
  bool csv_;
  Record base_;
  std::uint32_t complete_ = 0;  ///< the fields of a CSV line without empty cells
  std::vector<int> columns_;
};

}  // namespace slipproof
