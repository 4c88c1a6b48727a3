#include "records/certify/pieces.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <type_traits>

#include "base/crew/bytes.hpp"

namespace slipproof {

namespace {

static_assert(std::is_trivially_copyable_v<CertifySummary>);

std::string judged_bytes(const Judged& judged) {
  ByteWriter bytes;
  bytes.text(judged.lines);
  bytes.text({reinterpret_cast<const char*>(&judged.summary), sizeof judged.summary}).number(judged.broken ? 1 : 0);
  if (const auto& d = judged.broken) bytes.text(d->file).number(d->line).number(d->column).text(d->message);
  return bytes.take();
}

Judged read_judged(std::string_view text) {
  ByteReader bytes(text);
  Judged judged;
  judged.lines = bytes.text();
  const std::string_view summary = bytes.text();
  if (summary.size() != sizeof judged.summary) throw BrokenBytes();
  std::memcpy(&judged.summary, summary.data(), summary.size());
  if (bytes.number() != 0) {
    Diagnostic& d = judged.broken.emplace();
    d.file = bytes.text();
    d.line = bytes.number();
    d.column = bytes.number();
    d.message = bytes.text();
  }
  bytes.end();
  return judged;
}

CertifyOptions without_listener(CertifyOptions options) {
  options.judged = {};
  options.threads = 1;
  return options;
}

/// The bytes of a file, as many at once as are asked for, so that pieces are the same for everybody.
ByteSource whole_reads(const ByteFile& file) {
  return [&file, at = std::uint64_t{0}](char* buffer, std::size_t size) mutable {
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(size, file.size() - at));
    file.read(at, buffer, count);
    at += count;
    return count;
  };
}

}  // namespace

RecordPieces::RecordPieces(const CertifyOptions& options) : options_(without_listener(options)), bytes_(options.file) {
  ChunkReader chunks(whole_reads(bytes_), options.file);
  judge_.emplace(options_, chunks);
  try {
    Chunk chunk;
    while (chunks.next(chunk)) {
      ByteWriter request;
      request.number(chunks.offset() - chunk.text.size()).number(chunk.text.size());
      requests_.push_back(request.number(chunk.first_line).number(chunk.first_record).take());
    }
  } catch (const InputError& error) {
    mistake_ = error;
  }
}

std::string RecordPieces::input() const {
  std::error_code error;
  const auto changed = std::filesystem::last_write_time(options_.file, error).time_since_epoch().count();
  return options_.file + ' ' + std::to_string(bytes_.size()) + " bytes of " + std::to_string(changed);
}

std::string RecordPieces::answer(std::string_view request) const {
  ByteReader bytes(request);
  const std::uint64_t offset = bytes.number(), size = bytes.number(), line = bytes.number(), record = bytes.number();
  bytes.end();
  return judged_bytes(judge_->judge({bytes_.read(offset, static_cast<std::size_t>(size)), line, record}));
}

CertifySummary RecordPieces::certify(Crew& crew, const LineSink& output, const Progress& progress) const {
  CertifySummary summary;
  crew.each(
      requests_.size(), [&](std::uint64_t i) { return requests_[i]; },
      [&](std::uint64_t, const std::string& result) {
        write_judged(read_judged(result), summary, options_, output, progress);
      });
  if (mistake_) throw *mistake_;
  return summary;
}

}  // namespace slipproof
