// What a zip archive holds.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/byte_file.hpp"

namespace slipproof {

inline constexpr std::string_view zip_signature = "PK\x03\x04";

/// One file of an archive, as described by the directory.
struct ZipEntry {
  std::string name;
  std::uint64_t method = 0, checksum = 0, packed = 0, size = 0, offset = 0;
};

/// The directory, also of archives beyond 4 GiB. Throws InputError, as everything here.
std::vector<ZipEntry> zip_entries(const PlacedBytes& archive);

/// The bytes of a stored or deflated entry. Damage is reported at the entry's end. An entry inflates to at most 1032
/// times its packed size; one that claims to be larger is refused.
std::unique_ptr<ByteRun> zip_run(std::shared_ptr<const PlacedBytes> archive, const ZipEntry& entry);

}  // namespace slipproof
