// Reads a record from a line of text.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "records/reading/csv_line.hpp"
#include "records/reading/options.hpp"
#include "records/record/record_block.hpp"

namespace slipproof {

/// Columns and keys that are not fields.
inline constexpr int mode_column = -1, word_column = -2;

/// The field with a column's name, or one of the numbers above; nothing for an unknown name.
std::optional<int> find_column(const RecordFields& fields, std::string_view name);
/// The fields that records with these columns give. A field that is missing or given twice is a mistake.
std::vector<bool> fields_of_columns(const std::vector<int>& columns, const RecordFields& fields,
                                    const CertifiedMechanism& certified, Place place, Mistakes& mistakes);

/// The number of the mode that a text names; throws BrokenRecord.
std::uint16_t read_mode(const RecordFields& fields, std::string_view text, std::size_t place);
/// The value that a word stands for; throws BrokenRecord.
std::size_t read_word(const RecordFields& fields, std::string_view text, std::size_t place);

/// Reads the lines of a CSV file by its header, or JSON Lines by their keys. Immutable; may be shared by threads.
class RecordReader {
 public:
  /// `header` is the first line of a CSV file. Throws InputError at line 1.
  RecordReader(const CertifyOptions& options, const CertifiedMechanism& certified, const RecordFields& fields,
               std::string_view header);

  /// Throws BrokenRecord.
  void read(std::string_view line, Record& record) const;

  /// Whether plain lines can occur, which only CSV has.
  bool has_plain_lines() const { return csv_ && !options_.decimal_exact; }
  /// The fields of a plain line.
  const std::vector<bool>& plain_fields() const { return complete_; }
  PlainLines plain_lines() const { return PlainLines(columns_); }
  /// Reads a plain line, that is, a CSV line in which every number is a finite decimal and every text is known, into
  /// the next row of the block. The rows before must hold the lines that the same `lines` read before. Returns false
  /// for any other line; then use read().
  bool read_plain(const CsvLine& line, PlainLines& lines, RecordBlock& block) const;

 private:
  void read_json(std::string_view line, Record& record) const;

  void put(Record& record, int column, std::string_view text, std::size_t place) const;

  const CertifyOptions& options_;
  const CertifiedMechanism& certified_;
  const RecordFields& fields_;
  bool csv_;
  std::vector<int> columns_;
  std::vector<bool> complete_;  ///< the fields of a CSV line that has no empty cells
};

}  // namespace slipproof
