#include "records/tables/table.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <system_error>
#include <utility>

#include "base/files/npy_header.hpp"
#include "base/files/words.hpp"
#include "base/files/zip_archive.hpp"
#include "contact/formats/fclib.hpp"
#include "records/tables/hdf5_table.hpp"
#include "records/tables/table_builder.hpp"

namespace slipproof {

namespace {

using Placed = std::shared_ptr<const PlacedBytes>;

std::string dimensions_text(const std::vector<std::uint64_t>& shape) {
  std::string text;
  for (const std::uint64_t n : shape) text += (text.empty() ? "" : " x ") + std::to_string(n);
  return text.empty() ? "a single item" : text;
}

/// Adds columns of an array of two dimensions, with names from the options. `run_at(offset)` reads the file from there.
template <class RunAt>
void add_matrix(TableBuilder& table, const NpyHeader& header, const std::vector<std::string>& names,
                const RunAt& run_at) {
  const CellType& type = header.fields[0].type;
  const std::uint64_t rows = header.shape[0];
  const std::uint64_t columns = header.shape.size() == 2 ? header.shape[1] : 1;
  if (names.size() != columns) {
    table.fail("found " + std::to_string(columns) + " columns and " + std::to_string(names.size()) +
               " names of columns, expected --columns with a name for each, or a structured array");
  }
  if (!header.fortran) {
    const std::size_t part = table.add_part(run_at(header.start), type.size * names.size(), rows, "the array");
    for (std::size_t k = 0; k < names.size(); ++k) table.add_column({names[k], type, part, k * type.size});
    return;
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::size_t part = table.add_part(run_at(header.start + k * rows * type.size), type.size, rows, names[k]);
    table.add_column({names[k], type, part, 0});
  }
}

/// Adds the columns of an array with its own name or the names of its fields; the run must be at its data.
void add_array(TableBuilder& table, const NpyHeader& header, const std::string& name, std::unique_ptr<ByteRun> run) {
  if (header.shape.size() > 1) {
    table.fail((name.empty() ? "" : name + ": ") + "found " + dimensions_text(header.shape) +
               " items, expected one dimension");
  }
  const bool single = header.shape.empty();
  const std::size_t part =
      table.add_part(std::move(run), header.item, single ? 1 : header.shape[0], name.empty() ? "the array" : name);
  for (const NpyField& field : header.fields) {
    table.add_column({header.structured ? field.name : name, field.type, part, field.offset});
  }
}

void read_npy_table(TableBuilder& table, const Placed& file, const TableOptions& options) {
  auto run = std::make_unique<PlainRun>(file, 0);
  const NpyHeader header = read_npy_header(*run, file->size(), file->name(), "");
  if (header.structured) {
    table.refuse_names(options.names);
    add_array(table, header, "", std::move(run));
    return;
  }
  if (header.shape.empty() || header.shape.size() > 2) {
    table.fail("found an array of " + dimensions_text(header.shape) + ", expected records: one or two dimensions");
  }
  add_matrix(table, header, options.names,
             [&](std::uint64_t offset) { return std::make_unique<PlainRun>(file, offset); });
}

void read_npz_table(TableBuilder& table, const Placed& file, const TableOptions& options) {
  table.refuse_names(options.names);
  const std::vector<ZipEntry> entries = zip_entries(*file);
  if (entries.empty()) table.fail("found an empty archive, expected an array for each column");
  for (const ZipEntry& entry : entries) {
    if (!entry.name.ends_with(".npy")) {
      table.fail("found " + in_quotes(entry.name) + " in the archive, expected arrays (.npy)");
    }
    const std::string name = entry.name.substr(0, entry.name.size() - 4);
    auto run = zip_run(file, entry);
    const NpyHeader header = read_npy_header(*run, entry.size, file->name(), name + ": ");
    add_array(table, header, name, std::move(run));
  }
}

std::string beginning(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {};
  std::ifstream file(path, std::ios::binary);
  std::array<char, 8> bytes{};
  file.read(bytes.data(), bytes.size());
  return {bytes.data(), static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0))};
}

}  // namespace

void Table::skip(std::uint64_t count) {
  count = std::min(count, rows - next_row);
  for (TablePart& part : parts) {
    if (!part.constant) part.run->skip(count * part.item);
  }
  next_row += count;
}

bool Table::next(TableBlock& block) {
  constexpr std::size_t most_rows = 2048, bytes = 1U << 20U;
  std::size_t width = 1;
  for (const TablePart& part : parts) width += part.constant ? 0 : part.item;
  const std::size_t wanted = std::clamp<std::size_t>(bytes / width, 1, most_rows);
  block.first = next_row;
  block.rows = static_cast<std::size_t>(std::min<std::uint64_t>(wanted, rows - next_row));
  if (block.rows == 0) return false;
  block.parts.resize(parts.size());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    TablePart& part = parts[k];
    if (part.constant) continue;
    block.parts[k].resize(block.rows * part.item);
    part.run->read(block.parts[k].data(), block.parts[k].size());
  }
  next_row += block.rows;
  return true;
}

bool is_table_file(const std::string& path) {
  const std::string bytes = beginning(path);
  if (bytes.starts_with(hdf5_signature)) return !has_contact_problem(path);
  return bytes.starts_with(npy_signature) || bytes.starts_with(zip_signature) || bytes.starts_with("PK\x05\x06");
}

Table open_table(const std::string& path, const TableOptions& options) {
  const auto file = std::make_shared<const ByteFile>(path);
  const std::string bytes = file->read(0, static_cast<std::size_t>(std::min<std::uint64_t>(file->size(), 8)));
  TableBuilder table(path);
  const bool hdf5 = bytes.starts_with(hdf5_signature);
  if (!options.place.empty() && !hdf5) {
    table.fail("found no HDF5 file, in which " + in_quotes(options.place) + " could be a place");
  }
  if (hdf5) {
    table.refuse_names(options.names);
    read_hdf5_table(table, file, options.place);
  } else if (bytes.starts_with("PK")) {
    read_npz_table(table, file, options);
  } else {
    read_npy_table(table, file, options);
  }
  return table.finish();
}

}  // namespace slipproof
