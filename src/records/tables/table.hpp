// Tables of numbers in binary files: NumPy's arrays and archives, HDF5. Columns with names, rows in blocks.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/files/byte_file.hpp"
#include "base/files/cell_type.hpp"

namespace slipproof {

/// A column: cells of a part's items.
struct TableColumn {
  std::string name;
  CellType type;
  std::size_t part = 0;
  std::size_t offset = 0;  ///< in an item
};

/// Items of so many bytes, one a row; or a single one, which is the same for all.
struct TablePart {
  std::unique_ptr<ByteRun> run;
  std::size_t item = 0;
  bool constant = false;
  std::string value;  ///< the bytes of a constant
};

/// The bytes of some rows.
struct TableBlock {
  std::uint64_t first = 0;  ///< the number of the first row, from 0
  std::size_t rows = 0;
  std::vector<std::string> parts;
};

struct Table {
  std::string file;
  std::uint64_t rows = 0, next_row = 0;
  std::vector<TableColumn> columns;
  std::vector<TablePart> parts;

  /// The first of the column's cells in a block.
  const char* cells(const TableBlock& block, const TableColumn& column) const {
    const TablePart& part = parts[column.part];
    return (part.constant ? part.value : block.parts[column.part]).data() + column.offset;
  }
  /// Bytes from a row of the column to the next.
  std::size_t stride(const TableColumn& column) const {
    return parts[column.part].constant ? 0 : parts[column.part].item;
  }
  /// Passes over rows.
  void skip(std::uint64_t count);
  /// The next rows, 2048 or what takes a megabyte; false after the last. Throws InputError. A block that
  /// is used again keeps its memory.
  bool next(TableBlock& block);
};

struct TableOptions {
  std::vector<std::string> names;  ///< of the columns of an array without names
  std::string place;               ///< the data set or group of an HDF5 file; empty: the only one
};

/// Whether certify reads the file as a table: by how it begins, HDF5 unless it holds a contact problem.
bool is_table_file(const std::string& path);

/// A structured array, an array of two dimensions (in either order) with names from outside, an archive with an array a
/// column, a data set of HDF5 with fields, or a group with a data set a column. An array of a single item beside longer
/// ones is the same for all rows. Sizes are held against the file's before anything of theirs is allocated. Throws
/// InputError.
Table open_table(const std::string& path, const TableOptions& options = {});

}  // namespace slipproof
