#include "records/tables/table.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <system_error>
#include <utility>

#include "base/files/npy_header.hpp"
#include "base/files/words.hpp"

namespace slipproof {

namespace {

std::string dimensions_text(const std::vector<std::uint64_t>& shape) {
  std::string text;
  for (const std::uint64_t n : shape) text += (text.empty() ? "" : " x ") + std::to_string(n);
  return text.empty() ? "a single item" : text;
}

/// Gives a table its columns.
class TableBuilder {
 public:
  TableBuilder(std::shared_ptr<const PlacedBytes> file, const NpyHeader& header)
      : file_(std::move(file)), header_(header) {
    table_.file = file_->name();
    table_.rows = header.shape.empty() ? 1 : header.shape[0];
  }

  /// The columns of a structured array.
  Table fields(const std::vector<std::string>& names) {
    if (!names.empty()) fail("found columns that have names, expected no other ones from --columns");
    if (header_.shape.size() > 1) {
      fail("found " + dimensions_text(header_.shape) + " items, expected one dimension");
    }
    if (header_.fields.empty()) fail("found no column, expected a table with the numbers of records");
    add_part(header_.start, header_.item);
    for (const NpyField& field : header_.fields) table_.columns.push_back({field.name, field.type, 0, field.offset});
    return std::move(table_);
  }

  /// The columns of an array of two dimensions.
  Table matrix(const std::vector<std::string>& names) {
    if (header_.shape.empty() || header_.shape.size() > 2) {
      fail("found an array of " + dimensions_text(header_.shape) + ", expected records: one or two dimensions");
    }
    const std::uint64_t columns = header_.shape.size() == 2 ? header_.shape[1] : 1;
    if (names.size() != columns) {
      fail("found " + std::to_string(columns) + " columns and " + std::to_string(names.size()) +
           " names of columns, expected --columns with a name for each, or a structured array");
    }
    const CellType& type = header_.fields[0].type;
    if (!header_.fortran) add_part(header_.start, type.size * names.size());
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (header_.fortran) add_part(header_.start + k * table_.rows * type.size, type.size);
      table_.columns.push_back({names[k], type, header_.fortran ? k : 0, header_.fortran ? 0 : k * type.size});
    }
    return std::move(table_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { refuse(table_.file, message); }

  void add_part(std::uint64_t offset, std::size_t item) {
    constexpr std::size_t widest = 1U << 20U;
    if (item > widest) fail("found items of " + std::to_string(item) + " bytes, expected at most 1048576");
    table_.parts.push_back({ByteRun(file_, offset), item});
  }

  std::shared_ptr<const PlacedBytes> file_;
  const NpyHeader& header_;
  Table table_;
};

}  // namespace

void Table::skip(std::uint64_t count) {
  count = std::min(count, rows - next_row);
  for (TablePart& part : parts) part.run.skip(count * part.item);
  next_row += count;
}

bool Table::next(TableBlock& block) {
  constexpr std::size_t most_rows = 2048, bytes = 1U << 20U;
  std::size_t width = 1;
  for (const TablePart& part : parts) width += part.item;
  const std::size_t wanted = std::clamp<std::size_t>(bytes / width, 1, most_rows);
  block.first = next_row;
  block.rows = static_cast<std::size_t>(std::min<std::uint64_t>(wanted, rows - next_row));
  if (block.rows == 0) return false;
  block.parts.resize(parts.size());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    block.parts[k].resize(block.rows * parts[k].item);
    parts[k].run.read(block.parts[k].data(), block.parts[k].size());
  }
  next_row += block.rows;
  return true;
}

bool is_table_file(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::ifstream file(path, std::ios::binary);
  std::array<char, npy_signature.size()> bytes{};
  file.read(bytes.data(), bytes.size());
  return std::string_view(bytes.data(), bytes.size()) == npy_signature;
}

Table open_table(const std::string& path, const std::vector<std::string>& names) {
  const auto file = std::make_shared<const ByteFile>(path);
  ByteRun run(file, 0);
  const NpyHeader header = read_npy_header(run, file->size(), path);
  TableBuilder table(file, header);
  return header.structured ? table.fields(names) : table.matrix(names);
}

}  // namespace slipproof
