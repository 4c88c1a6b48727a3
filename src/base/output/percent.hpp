// Texts inside addresses.
#pragma once

#include <string>
#include <string_view>

namespace slipproof {

/// The text with each byte as %XX that is not a letter or digit of ASCII, one of `-_.~`, or one of `also`. RFC 3986.
std::string percent_encoded(std::string_view text, std::string_view also = {});

}  // namespace slipproof
