// NumPy's arrays as lists of numbers.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/npy_header.hpp"

namespace slipproof {

/// The first bytes of a NumPy archive (.npz), which slipproof does not read.
inline constexpr std::string_view zip_signature = "PK\x03\x04";

/// Reads an array of binary64, binary32 or integers (rounded to the nearest binary64), of either byte order, with one
/// dimension, or with two, row by row. Refuses more numbers than `most` before reading them. Throws InputError.
std::vector<double> read_npy(std::string_view bytes, const std::string& file, std::optional<std::size_t> most = {});

}  // namespace slipproof
