// FCLIB's files: contact problems of real simulations, in HDF5.
#pragma once

#include <string>
#include <string_view>

#include "contact/formats/problem_file.hpp"

namespace slipproof {

/// How every HDF5 file begins.
inline constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n";

/// The problem with its /solution and /guesses; see FORMATS.md. `file` is how messages call it. Throws InputError with
/// the path of what is not as it should be. Linear in what is stored, but for sorting.
ReadProblem read_fclib(const std::string& bytes, const std::string& file);

/// The /solution of such a file, which need not hold a problem. Throws InputError.
SolverAnswer read_fclib_answer(const std::string& bytes, const std::string& file, const AnswerSizes& sizes);

}  // namespace slipproof
