// The little that is needed of UTF-8: where characters end.
#pragma once

#include <cstddef>
#include <string_view>

namespace slipproof {

/// Bytes of the character with which `text` begins, 1 to 4; 0 if it begins with none (overlong forms and surrogates are
/// none).
std::size_t utf8_length(std::string_view text);

/// The number of characters: of bytes that do not continue one.
std::size_t utf8_count(std::string_view text);

}  // namespace slipproof
