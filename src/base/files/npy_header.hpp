// The header of a NumPy array: a dictionary as Python writes it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/byte_file.hpp"
#include "base/files/cell_type.hpp"

namespace slipproof {

inline constexpr std::string_view npy_signature = "\x93NUMPY";

struct NpyField {
  std::string name;
  CellType type;
  std::size_t offset = 0;  ///< within an item, in bytes
};

struct NpyHeader {
  std::vector<NpyField> fields;  ///< fields of a structured array; otherwise a single field without a name
  bool structured = false, fortran = false;
  std::size_t item = 0;              ///< bytes of an item
  std::vector<std::uint64_t> shape;  ///< empty for a single item
  std::uint64_t items = 1;           ///< the product of the shape
  std::uint64_t start = 0;           ///< offset of the data in bytes
};

/// Reads the header of an array of `size` bytes, and leaves the run at the data, whose size must be exactly what the
/// header says. Throws InputError. Refuses arrays of objects: only Python could read them, by running their code.
NpyHeader read_npy_header(ByteRun& run, std::uint64_t size, const std::string& file);

/// The type that '<f8' and its like name, in quotes or without.
CellType cell_type(std::string_view name);

}  // namespace slipproof
