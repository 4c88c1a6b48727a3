// NumPy's files, written by hand.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "support/bicycle/contact_mode.hpp"
#include "support/scenes/solver_records.hpp"

namespace slipproof::test {

inline constexpr std::size_t j_cell = 14;

inline std::string little(std::uint64_t value, std::size_t size) {
  std::string bytes;
  for (std::size_t k = 0; k < size; ++k) bytes += static_cast<char>(value >> (8 * k) & 0xff);
  return bytes;
}

/// A number of the type that `descr` names, '<f8' or '>i4'.
inline std::string npy_number(double x, const std::string& descr) {
  const std::size_t size = static_cast<std::size_t>(descr[2] - '0');
  const std::uint64_t bits = descr[1] != 'f' ? static_cast<std::uint64_t>(static_cast<std::int64_t>(x))
                             : size == 8     ? std::bit_cast<std::uint64_t>(x)
                                             : std::bit_cast<std::uint32_t>(static_cast<float>(x));
  std::string bytes = little(bits, size);
  if (descr[0] == '>') std::ranges::reverse(bytes);
  return bytes;
}

/// An array with this dictionary before its data.
inline std::string npy_with(const std::string& dictionary, const std::string& data, char version = 1) {
  return "\x93NUMPY" + std::string{version, '\0'} + little(dictionary.size(), version == 1 ? 2 : 4) + dictionary + data;
}

inline std::string npy_dictionary(const std::string& descr, const std::string& shape,
                                  const std::string& fortran = "False") {
  return "{'descr': " + descr + ", 'fortran_order': " + fortran + ", 'shape': " + shape + ", }\n";
}

/// A structured array of `count` rows; `descr` is its list of fields.
inline std::string npy_file(const std::string& descr, const std::string& rows, std::size_t count) {
  return npy_with(npy_dictionary(descr, "(" + std::to_string(count) + ",)"), rows);
}

/// The columns of solver_records.hpp: numbers as binary64, kind as a code of one byte, mode as a text of 12.
inline std::string npy_record_fields() {
  std::string descr = "[";
  for (std::size_t k = 0; k < record_columns.size(); ++k) {
    descr += "('" + record_columns[k] + "', '" + (k == kind_cell ? "|u1" : k == mode_cell ? "|S12" : "<f8") + "'), ";
  }
  return descr + "]";
}

inline std::string npy_row(const Cells& cells) {
  std::string row;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (k == kind_cell) {
      row += cells[k] == "internal" ? '\0' : '\1';
    } else if (k == mode_cell) {
      row += cells[k] + std::string(12 - cells[k].size(), '\0');
    } else {
      row += npy_number(std::strtod(cells[k].c_str(), nullptr), "<f8");
    }
  }
  return row;
}

}  // namespace slipproof::test
