// Headers and lines of CSV, whatever they are records of.
#pragma once

#include <fast_float/fast_float.h>

#include <cmath>
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

/// The cells of a line: set(column, value) for the usual number, put(column, text, place) for all others that are not
/// ignored; columns of numbers count from 0, and an empty cell of one is passed over. Throws BrokenRecord.
template <class Set, class Put>
void read_cells(std::string_view line, const std::vector<int>& columns, bool decimal_exact, const Set& set,
                const Put& put) {
  const char* at = line.data();
  const char* const end = at + line.size();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool last = i + 1 == columns.size();
    const int column = columns[i];
    if (column >= 0 && !decimal_exact) {  // the usual cell: a decimal, then a comma or the end
      double value = 0;
      const auto [stop, error] = fast_float::from_chars(at, end, value);
      if (error == std::errc() && std::isfinite(value) && (last ? stop == end : stop != end && *stop == ',')) {
        set(column, value);
        at = last ? end : stop + 1;
        continue;
      }
    }
    const auto rest = std::string_view(at, static_cast<std::size_t>(end - at));
    const std::size_t comma = rest.find(',');
    const std::size_t place = static_cast<std::size_t>(at - line.data()) + 1;
    if ((comma == std::string_view::npos) != last) {
      throw BrokenRecord{place, "found " + std::string(last ? "more" : "fewer") + " cells, expected " +
                                    std::to_string(columns.size()) + " as in the header"};
    }
    const std::string_view cell = trimmed(rest.substr(0, comma));
    if (!cell.empty() || column < 0) {
      if (column != ignored_column) put(column, cell, place);
    }
    if (!last) at += comma + 1;
  }
}

}  // namespace slipproof
