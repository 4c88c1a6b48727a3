// Headers and lines of CSV, whatever they are records of.
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

#include "certify/cells.hpp"
#include "certify/decimal_cells.hpp"
#include "input/diagnostic.hpp"

namespace slipproof {

/// The columns of a CSV header: find(name) gives a number for each, nothing for a name that is not known, which is a
/// mistake unless `ignore_unknown`; so is one that comes twice.
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

/// A line of CSV, by the places where its cells begin.
struct CsvLine {
  std::string_view line;
  std::string_view around = line;  ///< text that may be read, of which the line is a part

  const char* begin() const { return line.data(); }
  const char* end() const { return line.data() + line.size(); }
  /// The end of the cell that begins at `at`, if it is the usual one: a finite decimal up to a comma, or to the end of
  /// the line for the last one.
  const char* number(const char* at, bool last, double& value) const {
    const auto [stop, error] = fast_float::from_chars(at, end(), value);
    const bool usual =
        error == std::errc() && std::isfinite(value) && (last ? stop == end() : stop != end() && *stop == ',');
    return usual ? stop : nullptr;
  }
  /// What stands from there to the next comma, or to the end.
  std::string_view cell(const char* at) const {
    const auto rest = std::string_view(at, static_cast<std::size_t>(end() - at));
    return rest.substr(0, rest.find(','));
  }
};

/// The cells of a line: set(column, value) for the usual number, put(column, text, place) for all others that are not
/// ignored; columns of numbers count from 0, and an empty cell of one is passed over. Throws BrokenRecord.
template <class Set, class Put>
void read_cells(const CsvLine& line, const std::vector<int>& columns, bool decimal_exact, const Set& set,
                const Put& put) {
  const char* at = line.begin();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool last = i + 1 == columns.size();
    const int column = columns[i];
    double value = 0;
    if (column >= 0 && !decimal_exact) {
      if (const char* const stop = line.number(at, last, value); stop != nullptr) {
        set(column, value);
        at = last ? stop : stop + 1;
        continue;
      }
    }
    const std::string_view text = line.cell(at);
    const std::size_t place = static_cast<std::size_t>(at - line.begin()) + 1;
    if ((text.end() == line.line.end()) != last) {
      throw BrokenRecord{place, "found " + std::string(last ? "more" : "fewer") + " cells, expected " +
                                    std::to_string(columns.size()) + " as in the header"};
    }
    const std::string_view cell = trimmed(text);
    if (!cell.empty() || column < 0) {
      if (column != ignored_column) put(column, cell, place);
    }
    if (!last) at = text.end() + 1;
  }
}

/// How many bytes two texts begin with in common.
inline std::size_t common_length(std::string_view a, std::string_view b) {
  const std::size_t size = std::min(a.size(), b.size());
  constexpr std::size_t step = 32;
  std::size_t i = 0;
  while (i + step <= size && std::memcmp(a.data() + i, b.data() + i, step) == 0) i += step;
  while (i < size && a[i] == b[i]) ++i;
  return i;
}

/// Reads usual lines, one after the other: of numbers and texts that are known. In many a table the first columns stay
/// the same for a while; cells before the first byte in which a line differs from the one before are not read again.
class UsualLines {
 public:
  explicit UsualLines(const std::vector<int>& columns)
      : columns_(columns), numbers_(columns.size() + 1), ends_(columns.size()) {
    for (std::size_t i = columns.size(); i-- > 0;) numbers_[i] = columns[i] < 0 ? 0 : numbers_[i + 1] + 1;
  }

  /// There is no line before the next one.
  void forget() { before_ = {}; }

  /// set(column, value) takes a number; put(column, text) says whether it knows the text; repeat(column) takes what
  /// stands in the line before. False where anything is unusual, which read_cells() takes. The text has to outlive the
  /// next call.
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

  /// Those from column i on, which becomes the one behind them.
  template <class Set>
  bool read_numbers(const CsvLine& line, std::size_t& i, const Set& set) {
    const std::size_t count = std::min(numbers_[i], decimal_block);
    Decimals values;
    std::uint32_t unread = read_decimals(line.line, line.around, begin(i), std::span(ends_).subspan(i, count), values);
    for (; unread != 0; unread &= unread - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(unread));
      if (!line.number(line.begin() + begin(i + k), i + k + 1 == columns_.size(), values[k])) return false;
    }
    for (std::size_t k = 0; k < count; ++k) set(columns_[i + k], values[k]);
    i += count;
    return true;
  }

  const std::vector<int>& columns_;
  std::vector<std::size_t> numbers_;  ///< how many columns of numbers there are from each on
  std::string_view before_;
  std::vector<std::uint32_t> ends_;  ///< of its cells
};

}  // namespace slipproof
