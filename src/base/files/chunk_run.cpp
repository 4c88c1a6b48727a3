#include "base/files/chunk_run.hpp"

#include <algorithm>

#include "base/files/words.hpp"

#ifdef SLIPPROOF_ZLIB
#include <zlib.h>
#endif

namespace slipproof {

namespace {

/// Undoes shuffling, which puts the first bytes of all items first, then the second ones.
std::string unshuffled(const std::string& bytes, std::size_t item) {
  const std::size_t count = bytes.size() / item;
  std::string result(bytes);
  for (std::size_t k = 0; k < item; ++k) {
    for (std::size_t i = 0; i < count; ++i) result[i * item + k] = bytes[k * count + i];
  }
  return result;
}

}  // namespace

void ChunkLayout::check(const PlacedBytes& file) const {
  constexpr std::uint64_t longest = std::uint64_t{1} << 28U, usual = std::uint64_t{1} << 24U;
  const bool deflated = std::ranges::find(filters, ChunkFilter::deflate) != filters.end();
  std::uint64_t size = 0;
  if (__builtin_mul_overflow(rows, item, &size) || size > longest) {
    refuse(file.name(), path + ": found chunks of " + std::to_string(rows) + " items, which are too large");
  }
  if (rows > items && size > usual) {
    refuse(file.name(), path + ": found chunks of " + std::to_string(rows) + " items for " + std::to_string(items) +
                            ", expected no larger ones than what is in them");
  }
  for (const ChunkPlace& chunk : chunks) {
    const bool there = chunk.offset <= file.size() && file.size() - chunk.offset >= chunk.size;
    const bool holds = deflated ? size / 1032 <= chunk.size + 1 : chunk.size >= size;
    if (there && holds) continue;
    refuse(file.name(), path + ": found a chunk of " + std::to_string(chunk.size) + " bytes at byte " +
                            std::to_string(chunk.offset) + ", for which the file has no data");
  }
}

void ChunkRun::fail(const std::string& message) const {
  refuse(file_->name(), layout_.path + ": " + message);
}

std::string ChunkRun::inflated(const std::string& packed) const {
#ifdef SLIPPROOF_ZLIB
  std::string result(static_cast<std::size_t>(layout_.rows) * layout_.item, '\0');
  uLongf size = static_cast<uLongf>(result.size());
  const int code = uncompress(reinterpret_cast<Bytef*>(result.data()), &size,
                              reinterpret_cast<const Bytef*>(packed.data()), static_cast<uLong>(packed.size()));
  if (code != Z_OK || size != result.size()) fail("found a chunk that is damaged");
  return result;
#else
  fail("found compressed data, which this program cannot read: it was built without zlib");
#endif
}

void ChunkRun::unpack(std::uint64_t chunk) {
  const ChunkPlace& place = layout_.chunks[static_cast<std::size_t>(chunk)];
  bytes_ = file_->read(place.offset, static_cast<std::size_t>(place.size));
  for (std::size_t k = layout_.filters.size(); k-- > 0;) {
    switch (layout_.filters[k]) {
      case ChunkFilter::deflate:
        bytes_ = inflated(bytes_);
        break;
      case ChunkFilter::shuffle:
        bytes_ = unshuffled(bytes_, layout_.item);
        break;
      case ChunkFilter::fletcher32:  // four bytes at the end, which deflate's own checksum makes superfluous
        if (bytes_.size() < 4) fail("found a chunk that is damaged");
        bytes_.resize(bytes_.size() - 4);
        break;
    }
  }
  if (bytes_.size() != layout_.rows * layout_.item) fail("found a chunk that is damaged");
  held_ = chunk;
}

void ChunkRun::read(char* to, std::size_t count) {
  const std::uint64_t size = layout_.rows * layout_.item;
  while (count > 0) {
    const std::uint64_t chunk = position_ / size, at = position_ % size;
    if (chunk >= layout_.chunks.size()) fail("found the end of the chunks");
    if (chunk != held_) unpack(chunk);
    const std::size_t piece = std::min<std::size_t>(count, static_cast<std::size_t>(size - at));
    bytes_.copy(to, piece, static_cast<std::size_t>(at));
    to += piece;
    position_ += piece;
    count -= piece;
  }
}

}  // namespace slipproof
