// Tables of numbers in NumPy's arrays. Columns with names, rows in blocks.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/files/byte_file.hpp"
#include "base/files/cell_type.hpp"

namespace slipproof {

/// A column: one cell in each item of a part.
struct TableColumn {
  std::string name;
  CellType type;
  std::size_t part = 0;
  std::size_t offset = 0;  ///< bytes from the beginning of an item
};

/// Items of a fixed number of bytes, one for each row.
struct TablePart {
  ByteRun run;
  std::size_t item = 0;
};

/// The bytes of some rows.
struct TableBlock {
  std::uint64_t first = 0;  ///< number of the first row, from 0
  std::size_t rows = 0;
  std::vector<std::string> parts;
};

struct Table {
  std::string file;
  std::uint64_t rows = 0, next_row = 0;
  std::vector<TableColumn> columns;
  std::vector<TablePart> parts;

  /// The first cell of the column in a block.
  static const char* cells(const TableBlock& block, const TableColumn& column) {
    return block.parts[column.part].data() + column.offset;
  }
  /// Bytes from one row of the column to the next.
  std::size_t stride(const TableColumn& column) const { return parts[column.part].item; }
  /// Skips rows.
  void skip(std::uint64_t count);
  /// Reads the next rows: 2048, or as many as fit in a megabyte; false after the last. Throws InputError. A block that
  /// is used again keeps its memory.
  bool next(TableBlock& block);
};

/// Whether certify reads the file as a table: whether it begins as an array of NumPy.
bool is_table_file(const std::string& path);

/// Opens a structured array, or an array of two dimensions (in either order) whose columns have these names. The size
/// must be the file's before memory is allocated for it. Throws InputError.
Table open_table(const std::string& path, const std::vector<std::string>& names = {});

}  // namespace slipproof
