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

/// Of binary64, binary32 or integers (the nearest binary64 where one is none), of either byte order, with one or two
/// dimensions; the rows of two one after the other. More numbers than `most` are refused before they are read. Throws
/// InputError.
std::vector<double> read_npy(std::string_view bytes, const std::string& file, std::optional<std::size_t> most = {});

/// What is read of an array in an archive.
struct WantedArray {
  bool wanted = false;
  std::optional<std::size_t> most = std::nullopt;
};

/// The arrays of an archive, stored or deflated: those that `wanted` says; the only one under the name "r" if its own
/// is none of them. What they inflate to is at most 1032 times the file. Throws InputError.
std::vector<NamedNumbers> read_npz(std::string_view bytes, const std::string& file,
                                   const std::function<WantedArray(std::string_view name)>& wanted);

}  // namespace slipproof
