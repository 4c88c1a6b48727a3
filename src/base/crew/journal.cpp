#include "base/crew/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "base/crew/bytes.hpp"
#include "base/input/diagnostic.hpp"
#include "base/os/sha256.hpp"
#include "base/output/output_error.hpp"

namespace slipproof {

namespace {

constexpr std::string_view journal_signature = "slipproof-journal 1\n";
constexpr std::size_t digest_size = 64;
constexpr std::size_t record_head = digest_size + 8 + digest_size + 8;  // digest, then a text, then a length

std::string journal_head(std::string_view work) {
  return std::string(journal_signature) + ByteWriter().text(work).take();
}

bool is_regular(const Descriptor& file) {
  struct stat found {};
  return ::fstat(file.number(), &found) == 0 && S_ISREG(found.st_mode);
}

Descriptor open_journal(const std::filesystem::path& path) {
  Descriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  if (!file.open()) throw OutputError(path.string(), errno);
  if (::flock(file.number(), LOCK_EX | LOCK_NB) != 0) {
    throw OutputError(path.string(), errno == EWOULDBLOCK ? "another run is writing it" : "it cannot be locked");
  }
  if (!is_regular(file)) throw OutputError(path.string(), "it is no file");
  return file;
}

Descriptor journal_to_read(const std::filesystem::path& path) {
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));  // or it waits at a pipe
  if (!file.open()) {
    throw InputError({{path.string(), 0, 0, "cannot be read: " + std::generic_category().message(errno)}});
  }
  if (!is_regular(file))
    throw InputError({{path.string(), 0, 0, "found no regular file, expected what a run has kept"}});
  if (::flock(file.number(), LOCK_SH | LOCK_NB) != 0) {
    throw InputError({{path.string(), 0, 0, "found a run that is still writing it, expected a finished one"}});
  }
  return file;
}

std::string record_digest(std::string_view request_digest, std::string_view result) {
  return sha256(std::string(request_digest) + std::string(result));
}

}  // namespace

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

Journal::Journal(std::filesystem::path path, std::string_view work)
    : path_(std::move(path)), file_(open_journal(path_)) {
  const std::string head = journal_head(work);
  const std::string found = read_at(file_.number(), 0, head.size(), path_);
  // A killed run may have written only part of the head.
  if (found.size() < head.size() && head.starts_with(found)) {
    if (::ftruncate(file_.number(), 0) != 0) throw OutputError(path_.string(), errno);
    if (::lseek(file_.number(), 0, SEEK_SET) < 0) throw OutputError(path_.string(), errno);
    if (const int error = write_all(file_.number(), head)) throw OutputError(path_.string(), error);
    end_ = head.size();
    return;
  }
  if (!found.starts_with(journal_signature)) {
    throw InputError({{path_.string(), 0, 0, "found another file, expected a checkpoint, or none yet"}});
  }
  if (found != head) {
    throw InputError({{path_.string(), 0, 0,
                       "found a checkpoint of other work, expected one of the same arguments, version and input"}});
  }
  read_results(head.size());
  if (::ftruncate(file_.number(), static_cast<off_t>(end_)) != 0) throw OutputError(path_.string(), errno);
  if (::lseek(file_.number(), static_cast<off_t>(end_), SEEK_SET) < 0) throw OutputError(path_.string(), errno);
}

Journal::Journal(std::filesystem::path path) : path_(std::move(path)), file_(journal_to_read(path_)) {
  const std::string found = read_at(file_.number(), 0, journal_signature.size() + 8, path_);
  if (found.size() < journal_signature.size() + 8 || !found.starts_with(journal_signature)) {
    throw InputError({{path_.string(), 0, 0, "found another file, or a part of it, expected what a run has kept"}});
  }
  const std::uint64_t work = ByteReader(std::string_view(found).substr(journal_signature.size())).number();
  const std::uint64_t size = std::filesystem::file_size(path_);
  if (work < size - found.size()) read_results(found.size() + work);
  if (end_ != size) {
    throw InputError(
        {{path_.string(), 0, 0, fmt::format("found other bytes than were written, from byte {} on", end_ + 1)}});
  }
}

void Journal::read_results(std::uint64_t at) {
  struct stat found {};
  if (::fstat(file_.number(), &found) != 0) throw OutputError(path_.string(), errno);
  const auto size = static_cast<std::uint64_t>(found.st_size);
  while (size - at >= record_head) {
    const std::string head = read_at(file_.number(), at, record_head, path_);
    if (head.size() < record_head) break;
    const std::string digest = head.substr(0, digest_size);
    ByteReader rest(std::string_view(head).substr(digest_size));
    if (rest.number() != digest_size) break;
    std::string request = head.substr(digest_size + 8, digest_size);
    const std::uint64_t length = ByteReader(std::string_view(head).substr(digest_size + 8 + digest_size)).number();
    if (length > size - at - record_head) break;
    if (record_digest(request, read_at(file_.number(), at + record_head, length, path_)) != digest) break;
    places_.insert_or_assign(std::move(request), ResultPlace{at + record_head, length, digest});
    at += record_head + length;
  }
  end_ = at;
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
  const std::string record = digest + ByteWriter().text(key).text(result).take();
  if (const int error = write_all(file_.number(), record)) throw OutputError(path_.string(), error);
  places_.insert_or_assign(std::move(key), ResultPlace{end_ + record_head, result.size(), std::move(digest)});
  end_ += record.size();
}

void Journal::flush() const {
  if (::fsync(file_.number()) != 0) throw OutputError(path_.string(), errno);
}

}  // namespace slipproof
