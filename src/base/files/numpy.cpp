#include "base/files/numpy.hpp"

#include <cstdint>
#include <memory>

#include "base/files/byte_file.hpp"
#include "base/files/words.hpp"

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

}  // namespace

std::vector<double> read_npy(std::string_view bytes, const std::string& file, std::optional<std::size_t> most) {
  ByteRun run(std::make_shared<const MemoryBytes>(bytes, file), 0);
  const NpyHeader header = read_npy_header(run, bytes.size(), file);
  const CellType& type = header.fields[0].type;
  if (header.structured || !type.is_number()) {
    refuse(file, "found " + (header.structured ? "a structured array" : "the type " + in_quotes(type.name)) +
                     ", expected f8 or f4, or integers");
  }
  if (header.shape.empty() || header.shape.size() > 2) {
    refuse(file, "found " + std::to_string(header.shape.size()) + " dimensions, expected one or two");
  }
  refuse_more(file, "", header.items, most);
  return in_rows(header, bytes.substr(static_cast<std::size_t>(header.start)));
}

}  // namespace slipproof
