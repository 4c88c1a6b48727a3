// Zip archives, written by hand.
#pragma once

#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "support/files/npy_file.hpp"

#ifdef SLIPPROOF_ZLIB
#include <zlib.h>
#endif

namespace slipproof::test {

/// A file of an archive.
struct Packed {
  std::string name, bytes;
  std::size_t size = bytes.size();
  std::uint64_t method = 0, checksum = 0;
};

inline std::string zip(const std::vector<Packed>& files) {
  std::string archive, directory;
  for (const Packed& file : files) {
    const std::string common = little(file.method, 2) + little(0, 4) + little(file.checksum, 4) +
                               little(file.bytes.size(), 4) + little(file.size, 4) + little(file.name.size(), 2);
    directory += "PK\x01\x02" + little(20, 2) + little(20, 2) + little(0, 2) + common + std::string(12, char{0}) +
                 little(archive.size(), 4) + file.name;
    // The sizes before the data may be left open: what counts is the directory.
    archive += "PK\x03\x04" + little(20, 2) + little(0, 2) + little(file.method, 2) + little(0, 4) + little(0, 4) +
               little(0xffffffff, 4) + little(0xffffffff, 4) + little(file.name.size(), 2) + little(4, 2) + file.name +
               "more" + file.bytes;
  }
  return archive + directory + "PK\x05\x06" + little(0, 4) + little(files.size(), 2) + little(files.size(), 2) +
         little(directory.size(), 4) + little(archive.size(), 4) + little(0, 2);
}

#ifdef SLIPPROOF_ZLIB
inline Packed deflated(const std::string& name, const std::string& content) {
  z_stream stream{};
  REQUIRE(deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY) == Z_OK);
  std::string packed(content.size() + 100, '\0'), copy = content;
  stream.next_in = reinterpret_cast<Bytef*>(copy.data());
  stream.avail_in = static_cast<uInt>(copy.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  REQUIRE(deflate(&stream, Z_FINISH) == Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  const auto checksum = crc32(0, reinterpret_cast<const Bytef*>(copy.data()), static_cast<uInt>(copy.size()));
  return {name, packed, content.size(), 8, checksum};
}
#endif

}  // namespace slipproof::test
