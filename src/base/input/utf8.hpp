// The little that is needed of UTF-8: where characters end, and how wide text is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace slipproof {

/// Bytes of the character with which `text` begins, 1 to 4; 0 if it begins with none (overlong forms and surrogates are
/// none).
std::size_t utf8_length(std::string_view text);

/// Appends a character; a question mark if the number is not a Unicode scalar value.
void append_utf8(std::string& text, std::uint32_t c);

/// The number of characters, that is, of bytes that do not continue one.
std::size_t utf8_count(std::string_view text);

/// `start` and `text`, broken at blanks into lines of 80 columns unless a word is longer; further lines are indented by
/// the length of `start`.
std::string wrapped(const std::string& start, const std::string& text);

}  // namespace slipproof
