// Data sets of HDF5 in chunks, unpacked one chunk at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/files/byte_file.hpp"

namespace slipproof {

enum class ChunkFilter : std::uint8_t { deflate, shuffle, fletcher32 };

struct ChunkPlace {
  std::uint64_t offset = 0, size = 0;
};

/// The places of the chunks of a list of items, and how they are packed.
struct ChunkLayout {
  std::string path;  ///< how messages call it
  std::size_t item = 0;
  std::uint64_t rows = 0, items = 0;  ///< in a chunk, in all
  std::vector<ChunkFilter> filters;   ///< in the order in which they were applied
  std::vector<ChunkPlace> chunks;

  /// Throws InputError unless the chunks lie within the file and can hold their items.
  void check(const PlacedBytes& file) const;
};

class ChunkRun final : public ByteRun {
 public:
  ChunkRun(std::shared_ptr<const PlacedBytes> file, ChunkLayout layout)
      : file_(std::move(file)), layout_(std::move(layout)) {}
  void read(char* to, std::size_t count) override;
  void skip(std::uint64_t count) override { position_ += count; }

 private:
  [[noreturn]] void fail(const std::string& message) const;
  void unpack(std::uint64_t chunk);
  std::string inflated(const std::string& packed) const;

  std::shared_ptr<const PlacedBytes> file_;
  ChunkLayout layout_;
  std::uint64_t position_ = 0;
  std::uint64_t held_ = UINT64_MAX;  ///< the chunk in `bytes_`
  std::string bytes_;
};

}  // namespace slipproof
