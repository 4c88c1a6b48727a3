// Writes results to standard output.
#pragma once

#include <string_view>

namespace slipproof {

/// Writes without buffering. Throws OutputError if not all of the text could be written.
void write_standard_output(std::string_view text);

}  // namespace slipproof
