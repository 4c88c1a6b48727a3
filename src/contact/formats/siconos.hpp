// The text files of Siconos: numbers in sequence, whose content determines the kind of problem.
#pragma once

#include <string>
#include <string_view>

#include "contact/formats/problem_file.hpp"

namespace slipproof {

/// Reads a text as a local or global friction problem or a complementarity problem, whichever grammar the complete text
/// matches; see FORMATS.md. Throws InputError if it matches more than one, or none; then with the place where the
/// grammar that read farthest stopped. `file` is its name in messages. Linear in the text, except for sorting.
ProblemFile read_siconos(std::string_view text, const std::string& file);

/// Whether a text begins as those files do: with three counts.
bool begins_as_siconos(std::string_view text);

}  // namespace slipproof
