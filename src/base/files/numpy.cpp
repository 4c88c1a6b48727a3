#include "base/files/numpy.hpp"

#include <cstdint>
#include <memory>

#include "base/files/byte_file.hpp"
#include "base/files/words.hpp"
#include "base/files/zip_archive.hpp"

namespace slipproof {

namespace {

/// The items in C order, for any order of the file.
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

/// An array of `size` bytes. Its header alone says whether it is read.
std::vector<double> read_array(ByteRun& run, std::uint64_t size, const std::string& file, const std::string& where,
                               std::optional<std::size_t> most) {
  const NpyHeader header = read_npy_header(run, size, file, where);
  const CellType& type = header.fields[0].type;
  if (header.structured || !type.is_number()) {
    refuse(file, where + "found " + (header.structured ? "a structured array" : "the type " + in_quotes(type.name)) +
                     ", expected f8 or f4, or integers");
  }
  if (header.shape.empty() || header.shape.size() > 2) {
    refuse(file, where + "found " + std::to_string(header.shape.size()) + " dimensions, expected one or two");
  }
  refuse_more(file, where, header.items, most);
  std::string data(static_cast<std::size_t>(size - header.start), '\0');
  run.read(data.data(), data.size());
  return in_rows(header, data);
}

}  // namespace

std::vector<double> read_npy(std::string_view bytes, const std::string& file, std::optional<std::size_t> most) {
  PlainRun run(std::make_shared<const MemoryBytes>(bytes, file), 0);
  return read_array(run, bytes.size(), file, "", most);
}

std::vector<NamedNumbers> read_npz(std::string_view bytes, const std::string& file,
                                   const std::function<WantedArray(std::string_view name)>& wanted) {
  const auto archive = std::make_shared<const MemoryBytes>(bytes, file);
  std::vector<ZipEntry> entries = zip_entries(*archive);
  std::vector<NamedNumbers> result;
  std::uint64_t total = 0;
  for (ZipEntry& entry : entries) {
    if (entry.name.ends_with(".npy")) entry.name.resize(entry.name.size() - 4);
    const std::string name = entries.size() == 1 && !wanted(entry.name).wanted ? "r" : entry.name;
    const WantedArray array = wanted(name);
    if (!array.wanted) continue;
    // Many entries may point to the same data.
    if ((total += entry.size) > 1032 * (bytes.size() + 1)) refuse(file, "found sizes that the archive cannot have");
    result.push_back({name, read_array(*zip_run(archive, entry), entry.size, file, entry.name + ": ", array.most)});
  }
  return result;
}

}  // namespace slipproof
