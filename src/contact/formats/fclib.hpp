// FCLIB's files: contact problems of real simulations, in HDF5.
#pragma once

#include <string>
#include <string_view>

#include "contact/formats/problem_file.hpp"

namespace slipproof {

/// The first bytes of every HDF5 file.
inline constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n";

/// Reads the problem with its /solution and /guesses; see FORMATS.md. `file` is its name in messages. Throws InputError
/// with the path of the wrong part. Linear in the size of the file, except for sorting.
ReadProblem read_fclib(const std::string& bytes, const std::string& file);

/// The /solution of such a file, which need not hold a problem. Throws InputError.
SolverAnswer read_fclib_answer(const std::string& bytes, const std::string& file, const AnswerSizes& sizes);

}  // namespace slipproof
