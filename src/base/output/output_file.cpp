#include "base/output/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "base/os/descriptor.hpp"
#include "base/output/output_error.hpp"
#include "base/output/temporary_file.hpp"

namespace slipproof {

namespace {

std::filesystem::path folder_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : ".";
}

/// The N of /dev/fd/N, and of links that lead there: such a link is an open file, whatever its name.
std::optional<int> descriptor_named(const std::filesystem::path& path) {
  std::error_code error;
  const auto descriptors = std::filesystem::canonical("/proc/self/fd", error);
  if (error || std::filesystem::canonical(folder_of(path), error) != descriptors || error) return std::nullopt;
  const std::string name = path.filename().string();
  int number = -1;
  std::from_chars(name.data(), name.data() + name.size(), number);
  return number;
}

/// Where symbolic links lead, also to a file that is not there yet.
std::filesystem::path behind_links(std::filesystem::path path) {
  constexpr int most = 40;  // as the system has it: beyond, they lead in a circle
  std::error_code error;
  for (int i = 0; i < most && !descriptor_named(path) && std::filesystem::is_symlink(path, error); ++i) {
    path = folder_of(path) / std::filesystem::read_symlink(path, error);
  }
  return path;
}

/// Throws OutputError about `place` where `path` does not allow the access.
void need(const std::filesystem::path& path, int access, const std::filesystem::path& place) {
  if (::faccessat(AT_FDCWD, path.c_str(), access, AT_EACCESS) != 0) throw OutputError(place.string(), errno);
}

void need_folder(const std::filesystem::path& folder, const std::filesystem::path& place) {
  need(folder, F_OK, place);
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) throw OutputError(place.string(), ENOTDIR);
  need(folder, W_OK | X_OK, place);
}

/// The new file may be read and written by whom the older one could; others' files stay theirs, where that is allowed.
void keep_permissions(int file, const std::filesystem::path& older) {
  struct stat was {};
  if (::stat(older.c_str(), &was) != 0) return;
  if (::fchown(file, was.st_uid, was.st_gid) != 0) errno = 0;
  if (::fchmod(file, was.st_mode & 0777U) != 0) throw std::system_error(errno, std::generic_category());
}

}  // namespace

OutputError::OutputError(const std::string& place, int system_error)
    : OutputError(place, std::generic_category().message(system_error)) {}

OutputFile::OutputFile(std::filesystem::path path, const Inputs& inputs, Targets allowed)
    : path_(std::move(path)), target_(behind_links(path_)) {
  inputs.refuse(path_);
  if (descriptor_named(target_)) {
    kind_ = Kind::descriptor;
    return;
  }
  std::error_code error;
  const auto there = std::filesystem::status(target_, error);
  if (!std::filesystem::status_known(there)) throw OutputError(path_.string(), error.value());
  if (std::filesystem::is_directory(there)) throw OutputError(path_.string(), EISDIR);
  const bool exists = std::filesystem::exists(there);
  if (exists) need(target_, W_OK, path_);
  if (exists && !std::filesystem::is_regular_file(there)) {
    if (allowed == Targets::files) throw OutputError(path_.string(), "there is a pipe or a device of this name");
    kind_ = Kind::special;
    return;
  }
  if (!target_.has_filename()) throw OutputError(path_.string(), ENOENT);
  need_folder(folder_of(target_), path_);
}

void OutputFile::write(std::string_view contents) const {
  if (kind_ == Kind::file) return write_beside(contents);
  // A second open of the file would begin at its start: a copy of the descriptor continues at its position.
  const Descriptor file(kind_ == Kind::descriptor ? ::dup(*descriptor_named(target_))
                                                  : ::open(target_.c_str(), O_WRONLY | O_CLOEXEC));
  if (!file.open()) throw OutputError(path_.string(), errno);
  write_to(file.number(), contents);
}

void OutputFile::write_to(int descriptor, std::string_view contents) const {
  if (const int error = write_all(descriptor, contents)) throw OutputError(path_.string(), error);
}

void OutputFile::write_beside(std::string_view contents) const {
  try {
    TemporaryFile file(folder_of(target_));
    write_to(file.descriptor(), contents);
    keep_permissions(file.descriptor(), target_);
    if (::fsync(file.descriptor()) != 0) throw OutputError(path_.string(), errno);
    file.become(target_);
  } catch (const std::system_error& error) {
    throw OutputError(path_.string(), error.code().value());
  }
}

void write_file(const std::filesystem::path& path, std::string_view contents, const Inputs& inputs, Targets allowed) {
  OutputFile(path, inputs, allowed).write(contents);
}

OutputFolder::OutputFolder(std::filesystem::path path, Inputs inputs)
    : path_(std::move(path)), inputs_(std::move(inputs)) {
  if (::mkdir(path_.c_str(), 0777) != 0 && errno != EEXIST) throw OutputError(path_.string(), errno);
  need_folder(path_, path_);
}

void OutputFolder::write(const std::filesystem::path& name, std::string_view contents) const {
  const std::filesystem::path file = path_ / name;
  std::error_code error;
  std::filesystem::create_directories(folder_of(file), error);
  if (error) throw OutputError(file.string(), error.value());
  write_file(file, contents, inputs_, Targets::files);
}

}  // namespace slipproof
