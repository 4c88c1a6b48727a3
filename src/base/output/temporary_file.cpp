#include "base/output/temporary_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace slipproof {

namespace {

constexpr mode_t whatever_umask_leaves = 0666;

[[noreturn]] void fail(int error) {
  throw std::system_error(error, std::generic_category());
}

std::string link_to(const Descriptor& file) {
  return "/proc/self/fd/" + std::to_string(file.number());
}

/// Not open where the file system, or the lack of /proc, would leave it without a name for ever.
Descriptor nameless_file(const std::filesystem::path& folder) {
  Descriptor file(::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, whatever_umask_leaves));
  if (file.open() && ::access(link_to(file).c_str(), F_OK) != 0) return Descriptor(-1);
  return file;
}

}  // namespace

template <class Make>
void TemporaryFile::find_name(const std::filesystem::path& folder, const Make& make) {
  for (unsigned number = 1;; ++number) {
    const auto name = folder / (".slipproof-" + std::to_string(::getpid()) + "-" + std::to_string(number));
    if (make(name.c_str())) {
      name_ = name;
      return;
    }
    if (errno != EEXIST) fail(errno);
  }
}

TemporaryFile::TemporaryFile(const std::filesystem::path& folder) : folder_(folder), file_(nameless_file(folder)) {
  if (file_.open()) return;
  find_name(folder_, [this](const char* name) {
    file_ = Descriptor(::open(name, O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, whatever_umask_leaves));
    return file_.open();
  });
}

TemporaryFile::~TemporaryFile() {
  if (!name_.empty()) ::unlink(name_.c_str());
}

void TemporaryFile::become(const std::filesystem::path& target) {
  if (name_.empty()) {
    const std::string source = link_to(file_);
    find_name(folder_, [&source](const char* name) {
      return ::linkat(AT_FDCWD, source.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW) == 0;
    });
  }
  if (::rename(name_.c_str(), target.c_str()) != 0) fail(errno);
  name_.clear();
}

}  // namespace slipproof
