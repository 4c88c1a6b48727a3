// Files that are read at any place, and runs of their bytes that are read one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "base/os/descriptor.hpp"

namespace slipproof {

/// Bytes with random access, for any number of threads.
class PlacedBytes {
 public:
  explicit PlacedBytes(std::string name) : name_(std::move(name)) {}
  virtual ~PlacedBytes() = default;

  /// The name of the file in messages.
  const std::string& name() const { return name_; }
  std::uint64_t size() const { return size_; }
  /// Throws InputError if the bytes do not exist.
  void read(std::uint64_t offset, char* to, std::size_t count) const;
  std::string read(std::uint64_t offset, std::size_t count) const;

 protected:
  std::uint64_t size_ = 0;

 private:
  void check(std::uint64_t offset, std::size_t count) const;
  virtual void copy(std::uint64_t offset, char* to, std::size_t count) const = 0;

  std::string name_;
};

/// A regular file. Throws InputError if it becomes shorter while it is read.
class ByteFile final : public PlacedBytes {
 public:
  /// Throws InputError if it cannot be opened or is not a regular file.
  explicit ByteFile(const std::string& path);

 private:
  void copy(std::uint64_t offset, char* to, std::size_t count) const override;
  Descriptor descriptor_;
};

/// Bytes in memory, which must outlive it.
class MemoryBytes final : public PlacedBytes {
 public:
  MemoryBytes(std::string_view bytes, std::string name) : PlacedBytes(std::move(name)), bytes_(bytes) {
    size_ = bytes.size();
  }

 private:
  void copy(std::uint64_t offset, char* to, std::size_t count) const override { bytes_.copy(to, count, offset); }
  std::string_view bytes_;
};

/// Sequential bytes, in memory independent of their number.
class ByteRun {
 public:
  ByteRun(std::shared_ptr<const PlacedBytes> file, std::uint64_t offset) : file_(std::move(file)), offset_(offset) {}
  /// Throws InputError where the bytes are not there.
  void read(char* to, std::size_t count) {
    file_->read(offset_, to, count);
    offset_ += count;
  }
  void skip(std::uint64_t count) { offset_ += count; }

 private:
  std::shared_ptr<const PlacedBytes> file_;
  std::uint64_t offset_;
};

}  // namespace slipproof
