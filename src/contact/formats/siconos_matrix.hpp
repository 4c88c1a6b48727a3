// A matrix of Siconos' text files, in any of its three storages.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/algebra/sparse_matrix.hpp"
#include "base/files/words.hpp"

namespace slipproof {

struct MatrixSize {
  std::size_t rows = 0, columns = 0;
};

/// Reads it off `words`: of this size, or square if none is given. `name` is what messages call it. Throws FormatStop.
/// Adds to `remarks` when its numbers were printed with fewer digits than binary64 has.
SparseMatrix read_siconos_matrix(WordReader& words, const std::string& name, const std::optional<MatrixSize>& size,
                                 std::vector<std::string>& remarks);

}  // namespace slipproof
