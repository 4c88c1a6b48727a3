// Fingerprints of files.
#pragma once

#include <string>
#include <string_view>

namespace slipproof {

/// SHA-256 in hexadecimal.
std::string sha256(std::string_view bytes);

}  // namespace slipproof
