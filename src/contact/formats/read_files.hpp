// Contact problems and answers from files, whichever format they are in.
#pragma once

#include <string>
#include <string_view>

#include "contact/formats/problem_file.hpp"

namespace slipproof {

/// The problem in a file, told by its content (FORMATS.md), checked (`check_problem`) and with all remarks. Throws
/// InputError. Linear in the file, but for sorting matrices.
ReadProblem read_problem_file(const std::string& path);

/// The same of a line of JSON Lines, which begins at line 1 of `file` in messages.
ReadProblem read_problem_line(std::string_view line, const std::string& file);

/// What a solver gives, alone in a file; its origin is the path. Parts that are longer than `sizes` say are refused
/// before room is made for them; all else `check_answer` holds against a problem. Throws InputError.
SolverAnswer read_answer_file(const std::string& path, const AnswerSizes& sizes = {});

/// Whether a file begins as one that read_problem_file is for, and not as records in CSV or JSON lines: HDF5,
/// MatrixMarket, a text of Siconos, or a JSON object with the dimension 3, with M and H, with a sparse matrix, or on
/// several lines, but no JSON Lines. Never throws: what cannot be read, or can be read only once, is none.
bool is_problem_file(const std::string& path);

/// Whether a file has a JSON object on its first line and another one after it. Never throws, as above.
bool is_json_lines(const std::string& path);

}  // namespace slipproof
