// NumPy's files: an array (.npy), or several under their names (.npz).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/npy_header.hpp"

namespace slipproof {

struct NamedNumbers {
  std::string name;
  std::vector<double> numbers;
};

/// Reads an array of binary64, binary32 or integers (rounded to the nearest binary64), of either byte order, with one
/// dimension, or with two, row by row. Refuses more numbers than `most` before reading them. Throws InputError.
std::vector<double> read_npy(std::string_view bytes, const std::string& file, std::optional<std::size_t> most = {});

/// What is read of an array in an archive.
struct WantedArray {
  bool wanted = false;
  std::optional<std::size_t> most = std::nullopt;
};

/// Reads those arrays of an archive, stored or deflated, that `wanted` selects; a single array with any other name is
/// read as "r". They inflate to at most 1032 times the size of the file. Throws InputError.
std::vector<NamedNumbers> read_npz(std::string_view bytes, const std::string& file,
                                   const std::function<WantedArray(std::string_view name)>& wanted);

}  // namespace slipproof
