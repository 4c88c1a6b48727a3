// Writes results to standard output.
#pragma once

#include <string_view>

namespace slipproof {

/// Writes at once, past any buffer. Throws OutputError, so that nothing is lost in silence.
void write_standard_output(std::string_view text);

}  // namespace slipproof
