#include "base/crew/parts.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <map>
#include <system_error>
#include <utility>

#include "base/crew/bytes.hpp"
#include "base/input/diagnostic.hpp"
#include "base/os/sha256.hpp"
#include "base/output/output_error.hpp"

namespace slipproof {

namespace {

constexpr std::string_view end_request = "end";  // shorter than a request of a crew

void write_range(ByteWriter& bytes, const PartRange& range) {
  bytes.text(range.part).number(range.offset).number(range.size).text(range.digest);
}

PartRange read_range(ByteReader& bytes) {
  PartRange range;
  range.part = bytes.text();
  range.offset = bytes.number();
  range.size = bytes.number();
  range.digest = bytes.text();
  return range;
}

/// What is wrong with the bytes of a range, or nothing.
std::string complaint(const PartRange& range, const std::filesystem::path& path, std::string& bytes) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));  // or it waits at a pipe
  const std::string place = fmt::format("{} bytes of the output from byte {} on", range.size, range.offset + 1);
  if (!file.open()) return "cannot be read: " + std::generic_category().message(errno) + ", expected " + place;
  bytes = read_at(file.number(), range.offset, range.size, path);
  if (bytes.size() < range.size)
    return fmt::format("found {} bytes fewer, expected {}", range.size - bytes.size(), place);
  if (sha256(bytes) != range.digest) return "found other bytes than were written, expected " + place;
  return {};
}

}  // namespace

std::string PartRange::to_bytes() const {
  ByteWriter bytes;
  write_range(bytes, *this);
  return bytes.take();
}

PartRange PartRange::from_bytes(std::string_view text) {
  ByteReader bytes(text);
  PartRange range = read_range(bytes);
  bytes.end();
  return range;
}

std::filesystem::path parts_index(const std::string& prefix) {
  return prefix + ".index";
}

PartSizes::PartSizes(const std::string& prefix) {
  const std::filesystem::path path = prefix;
  const std::string name = path.filename().string();
  std::error_code error;
  for (const auto& entry :
       std::filesystem::directory_iterator(path.has_parent_path() ? path.parent_path() : ".", error)) {
    const std::string found = entry.path().filename().string();
    if (!found.starts_with(name)) continue;
    if (const std::uintmax_t size = entry.file_size(error); !error) sizes_.emplace(found.substr(name.size()), size);
  }
}

bool PartSizes::hold(const PartRange& range) const {
  const auto found = sizes_.find(range.part);
  return found != sizes_.end() && found->second >= range.offset + range.size;
}

PartRange PartWriter::add(std::string_view bytes) {
  PartRange range{{}, 0, bytes.size(), sha256(bytes)};
  const std::scoped_lock lock(mutex_);
  if (!file_.open()) make_file();
  const off_t at = ::lseek(file_.number(), 0, SEEK_END);
  if (at < 0) throw OutputError(prefix_ + part_, errno);
  if (const int error = write_all(file_.number(), bytes)) throw OutputError(prefix_ + part_, error);
  range.part = part_;
  range.offset = static_cast<std::uint64_t>(at);
  return range;
}

void PartWriter::make_file() {
  for (int run = 1; !file_.open(); ++run) {
    part_ = fmt::format(".{}.{}", rank_, run);
    file_ = Descriptor(::open((prefix_ + part_).c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!file_.open() && errno != EEXIST) throw OutputError(prefix_ + part_, errno);
  }
}

void keep_end(Journal& index, const PartsEnd& end) {
  ByteWriter bytes;
  bytes.number(end.ranges.size());
  for (const PartRange& range : end.ranges) write_range(bytes, range);
  bytes.text(end.out).text(end.err).number(static_cast<std::uint64_t>(end.exit_code));
  index.keep(end_request, bytes.take());
  index.flush();
}

PartsEnd read_end(const std::string& prefix) {
  const std::filesystem::path path = parts_index(prefix);
  const auto found = Journal(path).find(end_request);
  if (!found) {
    throw InputError({{path.string(), 0, 0,
                       "found an unfinished run, expected a finished one: run the same command again to continue"}});
  }
  ByteReader bytes(*found);
  PartsEnd end;
  for (std::uint64_t left = bytes.number(); left > 0; --left) end.ranges.push_back(read_range(bytes));
  end.out = bytes.text();
  end.err = bytes.text();
  end.exit_code = static_cast<int>(bytes.number());
  bytes.end();
  return end;
}

void read_parts(const std::string& prefix, const PartsEnd& end, const std::function<void(std::string_view)>& sink) {
  std::map<std::string, std::string> complaints;
  std::string bytes;
  for (const PartRange& range : end.ranges) {
    const std::string path = prefix + range.part;
    if (std::string found = complaint(range, path, bytes); !found.empty()) {
      complaints.try_emplace(path, std::move(found));
    } else {
      sink(bytes);
    }
  }
  if (complaints.empty()) return;
  std::vector<Diagnostic> diagnostics;
  for (auto& [path, message] : complaints) {
    diagnostics.push_back({path, 0, 0, message + "; delete this file and run the same command again"});
  }
  throw InputError(std::move(diagnostics));
}

}  // namespace slipproof
