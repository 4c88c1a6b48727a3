// NumPy's files: an array (.npy), or several under their names (.npz).
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/npy_header.hpp"

namespace slipproof {

struct NamedNumbers {
  std::string name;
  std::vector<double> numbers;
};

/// Of binary64 or binary32, of either byte order, with one or two dimensions; the rows of two one after the other.
/// Throws InputError; `name` is that of the array in the file, if it has one.
std::vector<double> read_npy(std::string_view bytes, const std::string& file, const std::string& name = {});

/// The arrays of an archive, stored or deflated: those whose names are `wanted`; the only one, whatever its name. What
/// they inflate to is at most 1032 times the file. Throws InputError.
std::vector<NamedNumbers> read_npz(std::string_view bytes, const std::string& file,
                                   const std::function<bool(std::string_view name)>& wanted);

}  // namespace slipproof
