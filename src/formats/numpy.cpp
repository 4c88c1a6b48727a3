#include "formats/numpy.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <utility>

#include "formats/words.hpp"

#ifdef SLIPPROOF_ZLIB
#include <zlib.h>
#endif

namespace slipproof {

namespace {

/// An unsigned integer of `size` bytes, the lowest first; 0 where they are not all there.
std::uint64_t little_endian(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint64_t value = 0;
  if (at > bytes.size() || bytes.size() - at < size) return 0;
  for (std::size_t k = size; k-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

class NpyArray {
 public:
  NpyArray(std::string_view bytes, std::string file, const std::string& name)
      : bytes_(bytes), file_(std::move(file)), where_(name.empty() ? "" : name + ": ") {}

  std::vector<double> read() {
    if (!bytes_.starts_with(npy_signature) || bytes_.size() < 12) fail("found no .npy array, expected one");
    const bool short_header = bytes_[6] == 1;
    const std::size_t start = short_header ? 10 : 12, size = little_endian(bytes_, 8, short_header ? 2 : 4);
    if (size > bytes_.size() - start) fail("found a header that is cut off");
    header_ = bytes_.substr(start, size);
    read_type();
    read_shape();
    data_ = bytes_.substr(start + size);
    const std::size_t elements = data_.size() / width_;
    const bool fits = columns_ == 0 ? data_.empty() : rows_ == elements / columns_ && elements % columns_ == 0;
    if (!fits || data_.size() % width_ != 0) {
      fail("found " + std::to_string(data_.size()) + " bytes of data, expected " + std::to_string(rows_) + " times " +
           std::to_string(columns_) + " numbers of " + std::to_string(width_) + " bytes");
    }
    std::vector<double> result;
    for (std::size_t i = 0; i < (columns_ == 0 ? 0 : rows_); ++i) {
      for (std::size_t j = 0; j < columns_; ++j) result.push_back(number(fortran_ ? j * rows_ + i : i * columns_ + j));
    }
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { refuse(file_, where_ + message); }

  /// What follows a key of the header, which is a dictionary of Python's.
  std::string_view after(std::string_view key) const {
    const std::size_t at = header_.find(key);
    if (at == std::string_view::npos) fail("found no " + std::string(key) + " in the header of an array");
    const std::string_view rest = header_.substr(at + key.size());
    return rest.substr(std::min(rest.find_first_not_of(": \t"), rest.size()));
  }

  void read_type() {
    const std::string_view type = after("'descr'");
    const bool little = type.starts_with("'<f"), known = little || type.starts_with("'>f");
    width_ = known && type.substr(3, 2) == "8'" ? 8 : known && type.substr(3, 2) == "4'" ? 4 : 0;
    if (width_ == 0) fail("found the type " + in_quotes(type.substr(0, type.find(','))) + ", expected f8 or f4");
    little_ = little;
    const std::string_view order = after("'fortran_order'");
    fortran_ = order.starts_with("True");
    if (!fortran_ && !order.starts_with("False")) fail("found no fortran_order, expected True or False");
  }

  void read_shape() {
    const std::string_view shape = after("'shape'");
    const std::string_view inside = shape.substr(0, shape.find(')'));
    std::vector<std::size_t> sizes;
    for (std::size_t at = 0; (at = inside.find_first_of("0123456789", at)) != std::string_view::npos;) {
      std::size_t size = 0;
      const auto [end, error] = std::from_chars(inside.data() + at, inside.data() + inside.size(), size);
      if (error != std::errc() || size > bytes_.size())
        fail("found the shape " + in_quotes(inside) + "), which is too large");
      sizes.push_back(size);
      at = static_cast<std::size_t>(end - inside.data());
    }
    if (!shape.starts_with('(') || sizes.empty() || sizes.size() > 2) {
      fail("found the shape " + in_quotes(shape.substr(0, inside.size() + 1)) + ", expected one or two dimensions");
    }
    rows_ = sizes[0];
    columns_ = sizes.size() == 2 ? sizes[1] : 1;
  }

  double number(std::size_t at) const {
    std::string raw(data_.substr(at * width_, width_));
    if (!little_) std::ranges::reverse(raw);
    const std::uint64_t bits = little_endian(raw, 0, width_);
    return width_ == 8 ? std::bit_cast<double>(bits)
                       : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
  }

  std::string_view bytes_, header_, data_;
  const std::string file_, where_;
  bool little_ = true, fortran_ = false;
  std::size_t width_ = 8, rows_ = 0, columns_ = 1;
};

/// One file of a zip archive, as its directory says.
struct ZipEntry {
  std::string name;
  std::uint64_t method = 0, checksum = 0, packed = 0, size = 0, offset = 0;
};

class ZipArchive {
 public:
  ZipArchive(std::string_view bytes, std::string file) : bytes_(bytes), file_(std::move(file)) {}

  std::vector<ZipEntry> entries() const {
    const std::size_t end = bytes_.rfind("PK\x05\x06");
    if (end == std::string_view::npos || bytes_.size() - end < 22) fail("found no directory: the archive is cut off");
    std::uint64_t at = number(end + 16, 4);
    std::vector<ZipEntry> result;
    for (std::uint64_t k = number(end + 10, 2); k > 0; --k) {
      if (at > bytes_.size() || bytes_.size() - at < 46 || bytes_.substr(at, 4) != "PK\x01\x02") {
        fail("found a directory that is damaged");
      }
      const std::uint64_t name = number(at + 28, 2);
      result.push_back({std::string(bytes_.substr(at + 46, name)), number(at + 10, 2), number(at + 16, 4),
                        number(at + 20, 4), number(at + 24, 4), number(at + 42, 4)});
      at += 46 + name + number(at + 30, 2) + number(at + 32, 2);
    }
    return result;
  }

  std::string content(const ZipEntry& entry) const {
    const std::uint64_t header = entry.offset;
    if (header > bytes_.size() || bytes_.size() - header < 30 || bytes_.substr(header, 4) != zip_signature) {
      fail(entry.name + ": found no such file in the archive");
    }
    const std::uint64_t data = header + 30 + number(header + 26, 2) + number(header + 28, 2);
    if (data > bytes_.size() || bytes_.size() - data < entry.packed)
      fail(entry.name + ": found an archive that is cut off");
    const std::string_view packed = bytes_.substr(data, entry.packed);
    if (entry.method == 0 && entry.packed == entry.size) return std::string(packed);
    if (entry.method != 8)
      fail(entry.name + ": found the method " + std::to_string(entry.method) + ", expected 0 or 8");
    return inflated(entry, packed);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { refuse(file_, message); }
  std::uint64_t number(std::uint64_t at, std::size_t size) const { return little_endian(bytes_, at, size); }

#ifdef SLIPPROOF_ZLIB
  std::string inflated(const ZipEntry& entry, std::string_view packed) const {
    if (entry.size > 1032 * (packed.size() + 1)) fail(entry.name + ": found a size that its data cannot have");
    std::string result(entry.size, '\0');
    z_stream stream{};
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) fail(entry.name + ": found data that zlib cannot read");
    // zlib reads through a pointer to bytes that are not const.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(result.data());
    stream.avail_out = static_cast<uInt>(result.size());
    const int code = inflate(&stream, Z_FINISH);
    const bool whole = code == Z_STREAM_END && stream.total_out == result.size();
    inflateEnd(&stream);
    const auto checksum = crc32(0, reinterpret_cast<const Bytef*>(result.data()), static_cast<uInt>(result.size()));
    if (!whole || checksum != entry.checksum) fail(entry.name + ": found data that are damaged");
    return result;
  }
#else
  std::string inflated(const ZipEntry& entry, std::string_view) const {
    fail(entry.name + ": found compressed data, which this program was built without zlib to read");
  }
#endif

  std::string_view bytes_;
  const std::string file_;
};

}  // namespace

std::vector<double> read_npy(std::string_view bytes, const std::string& file, const std::string& name) {
  return NpyArray(bytes, file, name).read();
}

std::vector<NamedNumbers> read_npz(std::string_view bytes, const std::string& file,
                                   const std::function<bool(std::string_view name)>& wanted) {
  const ZipArchive archive(bytes, file);
  std::vector<ZipEntry> arrays = archive.entries();
  for (ZipEntry& entry : arrays) {
    if (entry.name.ends_with(".npy")) entry.name.resize(entry.name.size() - 4);
  }
  if (arrays.size() != 1) std::erase_if(arrays, [&](const ZipEntry& entry) { return !wanted(entry.name); });
  std::vector<NamedNumbers> result;
  std::uint64_t total = 0;
  for (const ZipEntry& entry : arrays) {
    // Many entries may point to the same data.
    if ((total += entry.size) > 1032 * (bytes.size() + 1)) refuse(file, "found sizes that the archive cannot have");
    result.push_back({entry.name, read_npy(archive.content(entry), file, entry.name)});
  }
  return result;
}

}  // namespace slipproof
