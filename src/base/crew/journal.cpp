#include "base/crew/journal.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "base/crew/bytes.hpp"
#include "base/input/diagnostic.hpp"
#include "base/os/sha256.hpp"
#include "base/output/output_error.hpp"

namespace slipproof {

namespace {

constexpr std::string_view journal_signature = "slipproof-journal 2\n";
constexpr std::string_view earlier_signature = "slipproof-journal 1\n";
constexpr std::size_t digest_size = 64;
constexpr std::size_t record_head = 2 * digest_size + 8;  // two digests, then a length

/// The lock of an open file, which ends with the process and, unlike flock's, can be asked about.
struct flock write_lock() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

Descriptor open_journal(const std::filesystem::path& path) {
  Descriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  if (!file.open()) throw OutputError(path.string(), errno);
  struct stat found {};
  if (::fstat(file.number(), &found) != 0 || !S_ISREG(found.st_mode)) throw OutputError(path.string(), "it is no file");
  struct flock lock = write_lock();
  if (::fcntl(file.number(), F_OFD_SETLK, &lock) != 0) {
    const bool taken = errno == EACCES || errno == EAGAIN;
    throw OutputError(path.string(), taken ? "another run is writing it" : "it cannot be locked");
  }
  return file;
}

/// Up to `size` bytes from an offset on, fewer at the file's end.
std::string read_at(int file, std::uint64_t offset, std::uint64_t size, const std::filesystem::path& path) {
  std::string bytes(size, '\0');
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count = ::pread(file, bytes.data() + done, size - done, static_cast<off_t>(offset + done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw InputError({{path.string(), 0, 0, "cannot be read"}});
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  bytes.resize(done);
  return bytes;
}

std::string record_digest(std::string_view request_digest, std::string_view result) {
  return sha256(std::string(request_digest) + std::string(result));
}

}  // namespace

Journal::Journal(std::filesystem::path path, std::string_view work, Access access)
    : path_(std::move(path)), head_(std::string(journal_signature) + ByteWriter().text(work).take()) {
  if (access == Access::read) {
    refresh();
    return;
  }
  file_ = open_journal(path_);
  if (!check_head()) {
    if (::ftruncate(file_.number(), 0) != 0) throw OutputError(path_.string(), errno);
    if (const int error = write_all(file_.number(), head_)) throw OutputError(path_.string(), error);
  }
  end_ = head_.size();
  read_results();
  if (::ftruncate(file_.number(), static_cast<off_t>(end_)) != 0) throw OutputError(path_.string(), errno);
  if (::lseek(file_.number(), static_cast<off_t>(end_), SEEK_SET) < 0) throw OutputError(path_.string(), errno);
}

void Journal::refresh() {
  file_ = Descriptor(::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));  // anew, for file systems of a network
  if (!file_.open()) return;
  if (end_ == 0 && check_head()) end_ = head_.size();
  if (end_ != 0) read_results();
}

bool Journal::is_written(const std::filesystem::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct flock lock = write_lock();
  return file.open() && ::fcntl(file.number(), F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

/// Whether the head is there. A killed run may have written only a part of it.
bool Journal::check_head() const {
  const std::string found = read_at(file_.number(), 0, head_.size(), path_);
  if (found == head_) return true;
  if (found.size() < head_.size() && head_.starts_with(found)) return false;
  std::string mistake = "found another file, expected a checkpoint, or none yet";
  if (found.starts_with(journal_signature)) {
    mistake = "found a checkpoint of other work, expected one of the same arguments, version and input";
  } else if (found.starts_with(earlier_signature)) {
    mistake = "found a checkpoint of an earlier version, which cannot be continued, expected one of this version";
  }
  throw InputError({{path_.string(), 0, 0, std::move(mistake)}});
}

void Journal::read_results() {
  const auto size = static_cast<std::uint64_t>(::lseek(file_.number(), 0, SEEK_END));
  while (size >= end_ + record_head) {
    const std::string head = read_at(file_.number(), end_, record_head, path_);
    if (head.size() < record_head) return;
    std::string digest = head.substr(0, digest_size), request = head.substr(digest_size, digest_size);
    const std::uint64_t begin = end_ + record_head,
                        length = ByteReader(std::string_view(head).substr(2 * digest_size)).number();
    if (length > size - begin || record_digest(request, read_at(file_.number(), begin, length, path_)) != digest)
      return;
    places_.insert_or_assign(std::move(request), ResultPlace{begin, length, std::move(digest)});
    end_ = begin + length;
  }
}

bool Journal::has(std::string_view request) const {
  return places_.contains(sha256(request));
}

std::optional<std::string> Journal::find(std::string_view request) const {
  const std::string key = sha256(request);
  const auto place = places_.find(key);
  if (place == places_.end()) return std::nullopt;
  std::string result = read_at(file_.number(), place->second.offset, place->second.size, path_);
  if (record_digest(key, result) != place->second.digest) {
    throw InputError({{path_.string(), 0, 0, "found a result that was changed while it was in use"}});
  }
  return result;
}

void Journal::keep(std::string_view request, std::string_view result) {
  std::string key = sha256(request);
  std::string digest = record_digest(key, result);
  const std::string record = digest + key + ByteWriter().text(result).take();
  if (const int error = write_all(file_.number(), record)) throw OutputError(path_.string(), error);
  places_.insert_or_assign(std::move(key), ResultPlace{end_ + record_head, result.size(), std::move(digest)});
  end_ += record.size();
}

void Journal::flush() const {
  if (::fsync(file_.number()) != 0) throw OutputError(path_.string(), errno);
}

}  // namespace slipproof
