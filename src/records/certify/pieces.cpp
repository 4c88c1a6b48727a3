#include "records/certify/pieces.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <type_traits>

#include "base/crew/bytes.hpp"
#include "records/certify/judged.hpp"

namespace slipproof {

namespace {

static_assert(std::is_trivially_copyable_v<CertifySummary>);

std::string judged_bytes(const Judged& judged) {
  ByteWriter bytes;
  bytes.text(judged.lines);
  bytes.text({reinterpret_cast<const char*>(&judged.summary), sizeof judged.summary});
  if (const auto& d = judged.broken) bytes.number(d->line).number(d->column).text(d->message);
  return bytes.take();
}

Judged read_judged(std::string_view text, const std::string& file) {
  ByteReader bytes(text);
  Judged judged;
  judged.lines = bytes.text();
  const std::string_view summary = bytes.text();
  if (summary.size() != sizeof judged.summary) throw BrokenBytes();
  std::memcpy(&judged.summary, summary.data(), summary.size());
  if (bytes.rest().empty()) return judged;
  const std::uint64_t line = bytes.number(), column = bytes.number();
  judged.broken = {file, line, column, std::string(bytes.text())};
  bytes.end();
  return judged;
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

RecordPieces::RecordPieces(CertifyOptions options) : options_(std::move(options)), bytes_(options_.file) {
  options_.judged = {};
  options_.threads = 1;
  ChunkReader chunks(whole_reads(bytes_), options_.file);
  judge_.emplace(options_, chunks);
  try {
    for (Chunk chunk; chunks.next(chunk);) {
      pieces_.push_back({chunks.offset() - chunk.text.size(), chunk.text.size(), chunk.first_line, chunk.first_record});
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
  const Piece& piece = pieces_.at(ByteReader(request).number());
  return judged_bytes(judge_->judge({bytes_.read(piece.offset, piece.size), piece.first_line, piece.first_record}));
}

CertifySummary RecordPieces::certify(Crew& crew, const LineSink& output, const Progress& progress) const {
  CertifySummary summary;
  crew.each(
      pieces_.size(), [](std::uint64_t i) { return ByteWriter().number(i).take(); },
      [&](std::uint64_t, const std::string& result) {
        write_judged(read_judged(result, options_.file), summary, options_, output, progress);
      });
  if (mistake_) throw *mistake_;
  return summary;
}

}  // namespace slipproof
