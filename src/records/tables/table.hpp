// Tables of numbers in binary files: NumPy's arrays and archives, HDF5. Columns with names, rows in blocks.
#pragma once

#include <cstdint>
#include <memory>
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

/// Items of a fixed number of bytes, one for each row; or a single item, which is the same for all rows.
struct TablePart {
  std::unique_ptr<ByteRun> run;
  std::size_t item = 0;
  bool constant = false;
  std::string value;  ///< the bytes of a single item
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
  const char* cells(const TableBlock& block, const TableColumn& column) const {
    const TablePart& part = parts[column.part];
    return (part.constant ? part.value : block.parts[column.part]).data() + column.offset;
  }
  /// Bytes from one row of the column to the next.
  std::size_t stride(const TableColumn& column) const {
    return parts[column.part].constant ? 0 : parts[column.part].item;
  }
  /// Skips rows.
  void skip(std::uint64_t count);
  /// Reads the next rows: 2048, or as many as fit in a megabyte; false after the last. Throws InputError. A block that
  /// is used again keeps its memory.
  bool next(TableBlock& block);
};

struct TableOptions {
  std::vector<std::string> names;  ///< for the columns of an array that has no names
  std::string place;               ///< the data set or group of an HDF5 file; empty: the only one
};

/// Whether certify reads the file as a table. This depends on its first bytes; HDF5 is a table unless it holds a
/// contact problem.
bool is_table_file(const std::string& path);

/// Opens a structured array; an array of two dimensions (in either order) with names from the options; an archive with
/// one array for each column; an HDF5 data set with fields; or an HDF5 group with one data set for each column. An
/// array of a single item next to longer ones is the same for all rows. Sizes are checked against the file's size
/// before memory is allocated for them. Throws InputError.
Table open_table(const std::string& path, const TableOptions& options = {});

}  // namespace slipproof
