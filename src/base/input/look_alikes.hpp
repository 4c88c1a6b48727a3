// Characters that people write and that names and expressions do not know, and what to write instead: mu for a µ.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace slipproof {

/// The ASCII replacement of a character: `-` for U+2212, `mu` for U+00B5 and U+03BC; empty if there is none.
std::string_view in_ascii(char32_t character);

/// The first character of a text beyond ASCII and its code; nothing if all characters up to the first malformed byte
/// are ASCII.
struct OddCharacter {
  std::size_t position;  ///< position of its first byte
  std::string_view bytes;
  char32_t code;
};
std::optional<OddCharacter> first_odd_character(std::string_view text);

/// "`µ` (U+00B5; write `mu`)"; only the code, "U+202E", if the language has no replacement.
std::string describe(const OddCharacter& character);

}  // namespace slipproof
