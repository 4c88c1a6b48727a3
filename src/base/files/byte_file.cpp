#include "base/files/byte_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "base/files/words.hpp"

namespace slipproof {

namespace {

std::string system_message(int error) {
  return "cannot be read: " + std::generic_category().message(error);
}

}  // namespace

void PlacedBytes::check(std::uint64_t offset, std::size_t count) const {
  if (offset <= size_ && size_ - offset >= count) return;
  refuse(name_, "found the end at byte " + std::to_string(size_) + ", expected " + std::to_string(count) +
                    " bytes from byte " + std::to_string(offset) + " on: the file is cut off or damaged");
}

void PlacedBytes::read(std::uint64_t offset, char* to, std::size_t count) const {
  check(offset, count);
  copy(offset, to, count);
}

std::string PlacedBytes::read(std::uint64_t offset, std::size_t count) const {
  check(offset, count);
  std::string bytes(count, '\0');
  copy(offset, bytes.data(), count);
  return bytes;
}

ByteFile::ByteFile(const std::string& path)
    : PlacedBytes(path), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
  if (!descriptor_.open()) refuse(path, system_message(errno));
  struct stat found {};
  if (::fstat(descriptor_.number(), &found) != 0) refuse(path, system_message(errno));
  if (!S_ISREG(found.st_mode)) refuse(path, "found a file without random access, expected a regular file");
  size_ = static_cast<std::uint64_t>(found.st_size);
}

void ByteFile::copy(std::uint64_t offset, char* to, std::size_t count) const {
  while (count > 0) {
    const ssize_t got = ::pread(descriptor_.number(), to, count, static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse(name(), system_message(errno));
    if (got == 0) refuse(name(), "found its end too soon: the file became shorter while it was read");
    to += got;
    offset += static_cast<std::uint64_t>(got);
    count -= static_cast<std::size_t>(got);
  }
}

}  // namespace slipproof
