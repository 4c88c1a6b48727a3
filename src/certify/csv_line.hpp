// Headers and lines of CSV, whatever they are records of.
#pragma once

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "certify/cells.hpp"
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
  explicit UsualLines(std::size_t columns) : ends_(columns) {}

  /// There is no line before the next one.
  void forget() { before_ = {}; }

  /// set(column, value) takes a number; put(column, text) says whether it knows the text; repeat(column) takes what
  /// stands in the line before. False where anything is unusual, which read_cells() takes. The text has to outlive the
  /// next call.
  template <class Set, class Put, class Repeat>
  bool read(const CsvLine& line, const std::vector<int>& columns, const Set& set, const Put& put,
            const Repeat& repeat) {
    const std::size_t same = common_length(line.line, before_);
    before_ = {};
    std::size_t i = 0;
    for (; i + 1 < columns.size() && ends_[i] < same; ++i) repeat(columns[i]);
    const char* at = line.begin() + (i == 0 ? 0 : ends_[i - 1] + 1);
    for (; i < columns.size(); ++i) {
      const bool last = i + 1 == columns.size();
      const int column = columns[i];
      const char* end = nullptr;
      if (column >= 0) {
        double value = 0;
        end = line.number(at, last, value);
        set(column, value);
      } else {
        const std::string_view text = line.cell(at);
        const bool known = column == ignored_column || put(column, text);
        if (known && (text.end() == line.line.end()) == last) end = text.end();
      }
      if (end == nullptr) return false;
      ends_[i] = static_cast<std::size_t>(end - line.begin());
      at = last ? end : end + 1;
    }
    before_ = line.line;
    return true;
  }

 private:
  std::string_view before_;
  std::vector<std::size_t> ends_;  ///< of its cells
};

}  // namespace slipproof
