// The text files of Siconos: one number after another, told apart by their content.
#pragma once

#include <string>
#include <string_view>

#include "contact/formats/problem_file.hpp"

namespace slipproof {

/// A local or global friction problem or a complementarity problem, whichever the whole text is; see FORMATS.md. Throws
/// InputError where the grammar that came farthest stopped, or if the text fits more than one. `file` is how messages
/// call it. Linear in the text, but for sorting.
ProblemFile read_siconos(std::string_view text, const std::string& file);

/// Whether a text begins as those files do: with three counts.
bool begins_as_siconos(std::string_view text);

}  // namespace slipproof
