#include "base/files/zip_archive.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/files/words.hpp"

#ifdef SLIPPROOF_ZLIB
#include <zlib.h>
#endif

namespace slipproof {

namespace {

constexpr std::uint64_t open_32 = 0xFFFFFFFF;  ///< the number is in a field of 64 bits elsewhere

/// An unsigned integer of `size` bytes, the lowest first; 0 where they are not all there.
std::uint64_t little_endian(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint64_t value = 0;
  if (at > bytes.size() || bytes.size() - at < size) return 0;
  for (std::size_t k = size; k-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

struct Directory {
  std::uint64_t entries = 0, offset = 0, end = 0;
};

Directory directory_of(const PlacedBytes& archive) {
  constexpr std::uint64_t longest = 22 + 65535;
  const std::uint64_t from = archive.size() - std::min(archive.size(), longest);
  const std::string tail = archive.read(from, static_cast<std::size_t>(archive.size() - from));
  const std::size_t end = tail.rfind("PK\x05\x06");
  if (end == std::string::npos || tail.size() - end < 22) {
    refuse(archive.name(), "found no directory: the archive is cut off");
  }
  Directory result{little_endian(tail, end + 10, 2), little_endian(tail, end + 16, 4), from + end};
  if (end >= 20 && tail.compare(end - 20, 4, "PK\x06\x07") == 0) {
    const std::string larger = archive.read(little_endian(tail, end - 12, 8), 56);
    if (!larger.starts_with("PK\x06\x06")) refuse(archive.name(), "found a directory that is damaged");
    result.entries = little_endian(larger, 32, 8);
    result.offset = little_endian(larger, 48, 8);
  }
  if (result.offset > result.end) refuse(archive.name(), "found a directory that is damaged");
  return result;
}

/// Reads sizes and the offset that do not fit into 32 bits from an extra field.
void read_large(ZipEntry& entry, std::string_view extra) {
  for (std::size_t at = 0; at + 4 <= extra.size(); at += 4 + little_endian(extra, at + 2, 2)) {
    if (little_endian(extra, at, 2) != 1) continue;
    std::size_t next = at + 4;
    for (std::uint64_t* number : {&entry.size, &entry.packed, &entry.offset}) {
      if (*number != open_32) continue;
      *number = little_endian(extra, next, 8);
      next += 8;
    }
    return;
  }
}

#ifdef SLIPPROOF_ZLIB
class InflatedRun final : public ByteRun {
 public:
  InflatedRun(std::shared_ptr<const PlacedBytes> archive, ZipEntry entry, std::uint64_t offset)
      : archive_(std::move(archive)), entry_(std::move(entry)), offset_(offset), left_(entry_.packed) {
    if (inflateInit2(&stream_, -MAX_WBITS) != Z_OK) damaged();
  }
  InflatedRun(const InflatedRun&) = delete;
  InflatedRun& operator=(const InflatedRun&) = delete;
  ~InflatedRun() override { inflateEnd(&stream_); }

  void read(char* to, std::size_t count) override {
    if (count > entry_.size - done_) damaged();
    while (count > 0) {
      const auto piece = static_cast<uInt>(std::min<std::size_t>(count, 1U << 30U));
      inflate_to(to, piece);
      checksum_ = crc32(checksum_, reinterpret_cast<const Bytef*>(to), piece);
      to += piece;
      done_ += piece;
      count -= piece;
    }
    if (done_ == entry_.size && checksum_ != entry_.checksum) damaged();
  }

  void skip(std::uint64_t count) override {
    std::array<char, 16384> unused;
    for (; count > 0; count -= std::min<std::uint64_t>(count, unused.size())) {
      read(unused.data(), static_cast<std::size_t>(std::min<std::uint64_t>(count, unused.size())));
    }
  }

 private:
  [[noreturn]] void damaged() const { refuse(archive_->name(), entry_.name + ": found data that are damaged"); }

  void inflate_to(char* to, uInt count) {
    stream_.next_out = reinterpret_cast<Bytef*>(to);
    stream_.avail_out = count;
    while (stream_.avail_out > 0) {
      if (stream_.avail_in == 0 && left_ > 0) {
        const auto piece = static_cast<std::size_t>(std::min<std::uint64_t>(left_, packed_.size()));
        archive_->read(offset_, packed_.data(), piece);
        offset_ += piece;
        left_ -= piece;
        stream_.next_in = reinterpret_cast<Bytef*>(packed_.data());
        stream_.avail_in = static_cast<uInt>(piece);
      }
      const int code = inflate(&stream_, Z_NO_FLUSH);
      if (code != Z_OK && !(code == Z_STREAM_END && stream_.avail_out == 0)) damaged();
    }
  }

  std::shared_ptr<const PlacedBytes> archive_;
  ZipEntry entry_;
  std::uint64_t offset_, left_, done_ = 0;
  uLong checksum_ = 0;
  z_stream stream_{};
  std::array<char, 65536> packed_;
};
#endif

/// Where the bytes of an entry begin.
std::uint64_t zip_data(const PlacedBytes& archive, const ZipEntry& entry) {
  const bool there = entry.offset <= archive.size() && archive.size() - entry.offset >= 30;
  const std::string header = there ? archive.read(entry.offset, 30) : std::string();
  if (!header.starts_with(zip_signature)) refuse(archive.name(), entry.name + ": found no such file in the archive");
  const std::uint64_t data = entry.offset + 30 + little_endian(header, 26, 2) + little_endian(header, 28, 2);
  if (data > archive.size() || archive.size() - data < entry.packed) {
    refuse(archive.name(), entry.name + ": found an archive that is cut off");
  }
  return data;
}

}  // namespace

std::vector<ZipEntry> zip_entries(const PlacedBytes& archive) {
  const Directory directory = directory_of(archive);
  constexpr std::uint64_t longest = 1U << 26U;
  if (directory.end - directory.offset > longest) refuse(archive.name(), "found a directory that is too large");
  const std::string bytes = archive.read(directory.offset, static_cast<std::size_t>(directory.end - directory.offset));
  std::vector<ZipEntry> result;
  std::size_t at = 0;
  for (std::uint64_t k = directory.entries; k > 0; --k) {
    if (at > bytes.size() || bytes.size() - at < 46 || bytes.compare(at, 4, "PK\x01\x02") != 0) {
      refuse(archive.name(), "found a directory that is damaged");
    }
    const auto number = [&](std::size_t place, std::size_t size) { return little_endian(bytes, at + place, size); };
    const auto name = static_cast<std::size_t>(number(28, 2)), extra = static_cast<std::size_t>(number(30, 2));
    const std::string_view rest = std::string_view(bytes).substr(at + 46);
    ZipEntry entry{
        std::string(rest.substr(0, name)), number(10, 2), number(16, 4), number(20, 4), number(24, 4), number(42, 4)};
    if (name < rest.size()) read_large(entry, rest.substr(name, extra));
    result.push_back(std::move(entry));
    at += 46 + name + extra + static_cast<std::size_t>(number(32, 2));
  }
  return result;
}

std::unique_ptr<ByteRun> zip_run(std::shared_ptr<const PlacedBytes> archive, const ZipEntry& entry) {
  const std::uint64_t data = zip_data(*archive, entry);
  if (entry.method == 0 && entry.packed == entry.size) return std::make_unique<PlainRun>(std::move(archive), data);
  const auto fail = [&](const std::string& message) { refuse(archive->name(), entry.name + ": " + message); };
  if (entry.method != 8) fail("found the method " + std::to_string(entry.method) + ", expected 0 or 8");
  if (entry.size / 1032 > entry.packed + 1) fail("found a size that its data cannot have");
#ifdef SLIPPROOF_ZLIB
  return std::make_unique<InflatedRun>(std::move(archive), entry, data);
#else
  fail("found compressed data, which this program cannot read: it was built without zlib");
  return nullptr;
#endif
}

}  // namespace slipproof
