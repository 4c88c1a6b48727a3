// Reads claims files `slipproof/claims/1`, which proofs/CLAIMS.md describes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "claims/paper/claims_file.hpp"

namespace slipproof {

/// Reads a claims file. Throws InputError with all mistakes in the file, in the order of their places.
ClaimsFile read_claims(const std::filesystem::path& path);

/// The same from a text; `file` is its name in messages.
ClaimsFile parse_claims(std::string_view text, const std::string& file);

}  // namespace slipproof
