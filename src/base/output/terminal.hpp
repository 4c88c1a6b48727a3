// Whether output goes to a terminal, and colours and line breaks for it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace slipproof {

/// Whether a file descriptor is a terminal.
bool is_terminal(int descriptor);

/// Whether colours may be written there: to a terminal that has them (TERM is not `dumb`), unless the environment has
/// NO_COLOR with any text (no-color.org).
bool takes_colours(int descriptor);

enum class Emphasis : std::uint8_t { strong, good, bad, open };

/// The text between the escape sequences for bold, green, red or yellow.
std::string emphasised(std::string_view text, Emphasis emphasis);

/// The text with lines of more than 80 columns broken at blanks; what follows is indented by two columns more.
std::string narrow(std::string_view text);

}  // namespace slipproof
