// MatrixMarket: a matrix or a vector a file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contact/formats/problem_file.hpp"

namespace slipproof {

inline constexpr std::string_view matrix_market_banner = "%%MatrixMarket";

/// An array of one column (or one row). NaN and infinities are kept. Throws InputError.
/// More numbers than `most` are refused before they are read.
std::vector<double> read_market_vector(std::string_view text, const std::string& file,
                                       std::optional<std::size_t> most = {});

/// A matrix that must have this size: coordinate or array; real or integer; general, symmetric or skew-symmetric.
/// Throws InputError.
SparseMatrix read_market_matrix(std::string_view text, const std::string& file, std::size_t rows, std::size_t columns);

/// Reads the problem whose W is `text`, the content of NAME.mtx, with the files NAME_q.mtx, NAME_mu.mtx, NAME_r.mtx and
/// NAME_u.mtx in the same folder; see FORMATS.md. Throws InputError.
ReadProblem read_matrix_market(std::string_view text, const std::string& file);

}  // namespace slipproof
