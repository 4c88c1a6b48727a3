// A contact problem as one JSON object.
#pragma once

#include <istream>
#include <string>
#include <string_view>

#include "contact/formats/problem_file.hpp"

namespace slipproof {

/// See FORMATS.md for its keys. Throws InputError with the path of what is not as it should be ("W[3][2]", counted from
/// 1), or with line and column of what is no JSON.
ReadProblem read_json_problem(std::string_view text, const std::string& file);

/// Whether a text begins with an object that is for this reader rather than for that of records: one with the dimension
/// 3, with M and H, or with a sparse matrix, or any problem on several lines. Reads no more of it than it needs to
/// know.
bool begins_as_json_problem(std::istream& text);
/// The same of a line of JSON Lines, which is quick to say no to others.
bool is_json_problem(std::string_view line);

}  // namespace slipproof
