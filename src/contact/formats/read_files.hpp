// Contact problems and answers from files, whichever format they are in.
#pragma once

#include <string>
#include <string_view>

#include "contact/formats/json_problem.hpp"

namespace slipproof {

/// The formats of problem files, each with its kind of bytes: `FCLIB HDF5, Siconos text, ...`.
std::string problem_formats();

/// Reads the problem in a file; its content determines the format (FORMATS.md). Checks it (`check_problem`) and
/// collects all remarks. Throws InputError. Linear in the file, except for sorting matrices.
ReadProblem read_problem_file(const std::string& path);

/// The same for an object from a line of JSON Lines, which messages call line 1.
ReadProblem read_problem_line(const JsonProblem& json);

/// Reads a file with only an answer; its origin is the path. Refuses parts longer than `sizes` before memory is
/// allocated; check_answer() compares the rest with a problem. Throws InputError.
SolverAnswer read_answer_file(const std::string& path, const AnswerSizes& sizes = {});

/// Whether a file begins like one for read_problem_file, and not like records in CSV or JSON lines: HDF5, MatrixMarket,
/// a text of Siconos, or a JSON object with the dimension 3, with M and H, with a sparse matrix, or on several lines,
/// but not JSON Lines. Never throws: false for files that cannot be read, or only once.
bool is_problem_file(const std::string& path);

/// Whether a file has a JSON object on its first line and another one after it. Never throws, as above.
bool is_json_lines(const std::string& path);

}  // namespace slipproof
