#include "formats/numpy.hpp"

#include <cstdint>
#include <memory>
#include <utility>

#include "formats/byte_file.hpp"
#include "formats/words.hpp"
#include "formats/zip_archive.hpp"

namespace slipproof {

namespace {

/// The items in the order of C, whatever the file's is.
std::vector<double> in_rows(const NpyHeader& header, std::string_view data) {
  const CellType& type = header.fields[0].type;
  std::vector<double> numbers(static_cast<std::size_t>(header.items));
  read_numbers(type, data.data(), type.size, numbers.size(), numbers.data());
  if (!header.fortran || header.shape.size() < 2) return numbers;
  const auto rows = static_cast<std::size_t>(header.shape[0]), columns = static_cast<std::size_t>(header.shape[1]);
  std::vector<double> result(numbers.size());
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) result[i * columns + j] = numbers[j * rows + i];
  }
  return result;
}

}  // namespace

std::vector<double> read_npy(std::string_view bytes, const std::string& file, const std::string& name) {
  const std::string where = name.empty() ? "" : name + ": ";
  PlainRun run(std::make_shared<const MemoryBytes>(bytes, file), 0);
  const NpyHeader header = read_npy_header(run, bytes.size(), file, where);
  if (header.structured || header.fields[0].type.kind != CellType::Kind::real) {
    const std::string found =
        header.structured ? "a structured array" : "the type " + in_quotes(header.fields[0].type.name);
    refuse(file, where + "found " + found + ", expected f8 or f4");
  }
  if (header.shape.empty() || header.shape.size() > 2) {
    refuse(file, where + "found " + std::to_string(header.shape.size()) + " dimensions, expected one or two");
  }
  return in_rows(header, bytes.substr(static_cast<std::size_t>(header.start)));
}

std::vector<NamedNumbers> read_npz(std::string_view bytes, const std::string& file,
                                   const std::function<bool(std::string_view name)>& wanted) {
  const auto archive = std::make_shared<const MemoryBytes>(bytes, file);
  std::vector<ZipEntry> arrays = zip_entries(*archive);
  for (ZipEntry& entry : arrays) {
    if (entry.name.ends_with(".npy")) entry.name.resize(entry.name.size() - 4);
  }
  if (arrays.size() != 1) std::erase_if(arrays, [&](const ZipEntry& entry) { return !wanted(entry.name); });
  std::vector<NamedNumbers> result;
  std::uint64_t total = 0;
  for (const ZipEntry& entry : arrays) {
    // Many entries may point to the same data.
    if ((total += entry.size) > 1032 * (bytes.size() + 1)) refuse(file, "found sizes that the archive cannot have");
    std::string content;
    const auto run = zip_run(archive, entry);
    content.resize(static_cast<std::size_t>(entry.size));
    run->read(content.data(), content.size());
    result.push_back({entry.name, read_npy(content, file, entry.name)});
  }
  return result;
}

}  // namespace slipproof
