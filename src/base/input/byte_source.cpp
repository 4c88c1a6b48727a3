#include "base/input/byte_source.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <system_error>
#include <utility>

#include "base/input/diagnostic.hpp"
#include "base/os/descriptor.hpp"

namespace slipproof {

namespace {

InputError unreadable(const std::string& file, int error) {
  return InputError({{file, 0, 0, "cannot be read: " + std::generic_category().message(error)}});
}

std::size_t read_some(int descriptor, char* buffer, std::size_t size, const std::string& file) {
  while (true) {
    const ssize_t count = ::read(descriptor, buffer, size);
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EINTR) throw unreadable(file, errno);
  }
}

}  // namespace

ByteSource open_bytes(const std::string& file) {
  if (file == "-") {
    return [](char* buffer, std::size_t size) { return read_some(STDIN_FILENO, buffer, size, "standard input"); };
  }
  const auto opened = std::make_shared<Descriptor>(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (!opened->open()) throw unreadable(file, errno);
  struct stat found {};
  if (::fstat(opened->number(), &found) == 0 && S_ISDIR(found.st_mode)) throw unreadable(file, EISDIR);
  return [opened, file](char* buffer, std::size_t size) { return read_some(opened->number(), buffer, size, file); };
}

ByteSource bytes_of(std::istream& stream, std::string file) {
  return [&stream, file = std::move(file)](char* buffer, std::size_t size) {
    stream.read(buffer, static_cast<std::streamsize>(size));
    if (stream.bad()) throw InputError({{file, 0, 0, "cannot be read"}});
    return static_cast<std::size_t>(stream.gcount());
  };
}

}  // namespace slipproof
