// Headers and lines of CSV, for all kinds of records.
#pragma once

#include <fast_float/fast_float.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "records/reading/decimal_cells.hpp"
#include "records/record/cells.hpp"

namespace slipproof {

/// Finds the columns of a CSV header. find(name) returns a number for each name, or nothing for an unknown one, which
/// is a mistake unless `ignore_unknown`. A name that occurs twice is a mistake, too.
template <class Find>
std::vector<int> read_header(std::string_view header, bool ignore_unknown, Mistakes& mistakes, const Find& find) {
  if (header.substr(0, 3) == "\xEF\xBB\xBF") header.remove_prefix(3);
  std::vector<int> columns;
  std::size_t place = 1;
  while (true) {
    const std::size_t comma = header.find(',');
    const std::string_view name = trimmed(header.substr(0, comma));
    const std::optional<int> column = find(name);
    if (!column && !ignore_unknown) {
      mistakes.add({1, place},
                   "found the column " + in_quotes(name) + ", expected a parameter or a part of the answer");
    }
    for (const int before : columns) {
      if (!column || before != *column) continue;
      mistakes.add({1, place}, "found the column " + in_quotes(name) + " twice, expected it once");
    }
    columns.push_back(column.value_or(ignored_column));
    if (comma == std::string_view::npos) return columns;
    place += comma + 1;
    header.remove_prefix(comma + 1);
  }
}

/// A line of CSV, and the text that contains it.
struct CsvLine {
  std::string_view line;
  std::string_view around = line;  ///< text that may be read; it contains the line
};

/// The number in a plain cell, which contains a finite decimal and nothing else; nothing for other cells.
inline std::optional<double> plain_number(std::string_view cell) {
  double value = 0;
  const auto [stop, error] = fast_float::from_chars(cell.data(), cell.data() + cell.size(), value);
  const bool plain = error == std::errc() && stop == cell.data() + cell.size() && std::isfinite(value);
  return plain ? std::optional(value) : std::nullopt;
}

/// Reads the cells of a line. Calls set(column, value) for a plain number, put(column, text, place) for all other cells
/// that are not ignored. Columns of numbers count from 0; an empty cell in one is skipped. Throws BrokenRecord.
template <class Set, class Put>
void read_cells(std::string_view line, const std::vector<int>& columns, bool decimal_exact, const Set& set,
                const Put& put) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool last = i + 1 == columns.size();
    const int column = columns[i];
    const std::size_t comma = line.find(',', begin), place = begin + 1;
    if ((comma == std::string_view::npos) != last) {
      throw BrokenRecord{place, "found " + std::string(last ? "more" : "fewer") + " cells, expected " +
                                    std::to_string(columns.size()) + " as in the header"};
    }
    const std::string_view text = line.substr(begin, comma - begin);
    begin = comma + 1;
    if (column >= 0 && !decimal_exact) {
      if (const auto number = plain_number(text)) {
        set(column, *number);
        continue;
      }
    }
    const std::string_view cell = trimmed(text);
    if (!cell.empty() || column < 0) {
      if (column != ignored_column) put(column, cell, place);
    }
  }
}

/// The length of the longest common beginning of two texts.
inline std::size_t common_length(std::string_view a, std::string_view b) {
  const std::size_t size = std::min(a.size(), b.size());
  constexpr std::size_t step = 32;
  std::size_t i = 0;
  while (i + step <= size && std::memcmp(a.data() + i, b.data() + i, step) == 0) i += step;
  while (i < size && a[i] == b[i]) ++i;
  return i;
}

/// Reads plain lines in order: lines with plain numbers and known texts only. Does not read cells before the first byte
/// that differs from the previous line again, since in many tables the first columns repeat.
class PlainLines {
 public:
  explicit PlainLines(const std::vector<int>& columns)
      : columns_(columns), numbers_(columns.size() + 1), ends_(columns.size()) {
    for (std::size_t i = columns.size(); i-- > 0;) numbers_[i] = columns[i] < 0 ? 0 : numbers_[i + 1] + 1;
  }

  /// The next line has no predecessor.
  void forget() { before_ = {}; }

  /// set(column, value) stores a number; put(column, text) returns whether the text is known; repeat(column) keeps the
  /// value of the line before. Returns false if anything is unusual; read_cells() then reads the line. The text must
  /// exist until the next call returns.
  template <class Set, class Put, class Repeat>
  bool read(const CsvLine& line, const Set& set, const Put& put, const Repeat& repeat) {
    const std::size_t same = common_length(line.line, before_);
    before_ = {};
    if (!find_cell_ends(line.line, line.around, ends_)) return false;
    std::size_t i = 0;
    for (; i + 1 < columns_.size() && ends_[i] < same; ++i) repeat(columns_[i]);
    while (i < columns_.size()) {
      if (numbers_[i] > 0) {
        if (!read_numbers(line, i, set)) return false;
      } else {
        if (columns_[i] != ignored_column && !put(columns_[i], cell(line, i))) return false;
        ++i;
      }
    }
    before_ = line.line;
    return true;
  }

 private:
  std::size_t begin(std::size_t i) const { return i == 0 ? 0 : ends_[i - 1] + 1; }
  std::string_view cell(const CsvLine& line, std::size_t i) const {
    return line.line.substr(begin(i), ends_[i] - begin(i));
  }

  /// Reads the columns of numbers from column i on; i becomes the column after them.
  template <class Set>
  bool read_numbers(const CsvLine& line, std::size_t& i, const Set& set) {
    const std::size_t count = std::min(numbers_[i], decimal_block);
    Decimals values;
    std::uint32_t unread = read_decimals(line.line, line.around, begin(i), std::span(ends_).subspan(i, count), values);
    for (; unread != 0; unread &= unread - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(unread));
      const auto number = plain_number(cell(line, i + k));
      if (!number) return false;
      values[k] = *number;
    }
    for (std::size_t k = 0; k < count; ++k) set(columns_[i + k], values[k]);
    i += count;
    return true;
  }

  const std::vector<int>& columns_;
  std::vector<std::size_t> numbers_;  ///< by column: how many consecutive columns of numbers begin there
  std::string_view before_;
  std::vector<std::uint32_t> ends_;  ///< the ends of the cells in that line
};

}  // namespace slipproof
