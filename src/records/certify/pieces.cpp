#include "records/certify/pieces.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "base/crew/bytes.hpp"
#include "base/os/descriptor.hpp"
#include "records/certify/chunk_judge.hpp"
#include "records/reading/chunk_reader.hpp"

namespace slipproof {

namespace {

enum class PieceQuestion : std::uint64_t { count, judge };

/// The lines of a piece, and whether a line that is too long ends them.
struct PieceLines {
  std::string text;
  bool too_long = false;
};

struct PieceCount {
  std::uint64_t lines = 0, records = 0;
  bool too_long = false;
};

PieceCount count_lines(const PieceLines& piece) {
  PieceCount count{.too_long = piece.too_long};
  each_line(piece.text, [&](std::string_view line) {
    ++count.lines;
    if (!blank(line)) ++count.records;
  });
  return count;
}

std::string summary_bytes(const CertifySummary& s) {
  ByteWriter bytes;
  bytes.number(s.records).number(s.broken).number(s.with_rho).number(s.others_possible);
  for (const std::uint64_t count : s.verdicts) bytes.number(count);
  for (const std::uint64_t count : s.tiers) bytes.number(count);
  return bytes.real(s.worst_certified_error).real(s.worst_error).real(s.worst_rho).take();
}

CertifySummary read_summary(std::string_view text) {
  CertifySummary s;
  ByteReader bytes(text);
  s.records = bytes.number();
  s.broken = bytes.number();
  s.with_rho = bytes.number();
  s.others_possible = bytes.number();
  for (std::uint64_t& count : s.verdicts) count = bytes.number();
  for (std::uint64_t& count : s.tiers) count = bytes.number();
  s.worst_certified_error = bytes.real();
  s.worst_error = bytes.real();
  s.worst_rho = bytes.real();
  bytes.end();
  return s;
}

std::string judged_bytes(const Judged& judged) {
  ByteWriter bytes;
  bytes.text(judged.lines).text(summary_bytes(judged.summary)).number(judged.broken ? 1 : 0);
  if (const auto& d = judged.broken) bytes.text(d->file).number(d->line).number(d->column).text(d->message);
  return bytes.take();
}

Judged read_judged(std::string_view text) {
  ByteReader bytes(text);
  Judged judged;
  judged.lines = bytes.text();
  judged.summary = read_summary(bytes.text());
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

}  // namespace

class RecordPieces::File {
 public:
  File(const CertifyOptions& options, std::uint64_t piece_size)
      : options_(without_listener(options)),
        piece_size_(piece_size),
        file_(opened(options.file)),
        reader_(source(), options.file) {
    struct stat found {};
    if (::fstat(file_.number(), &found) != 0) throw unreadable(options.file, errno);
    if (!S_ISREG(found.st_mode)) {
      throw InputError({{options.file, 0, 0, "found no file, expected one that every rank can read ranges of"}});
    }
    size_ = static_cast<std::uint64_t>(found.st_size);
    changed_ = std::to_string(found.st_mtim.tv_sec) + '.' + std::to_string(found.st_mtim.tv_nsec);
    judge_.emplace(options_, reader_);
    begin_ = reader_.offset();
  }

  std::uint64_t pieces() const { return (size_ - std::min(begin_, size_) + piece_size_ - 1) / piece_size_; }
  std::string input() const {
    return options_.file + ' ' + std::to_string(size_) + " bytes of " + changed_ + ", in pieces of " +
           std::to_string(piece_size_);
  }
  std::uint64_t first_line() const { return reader_.line(); }
  const CertifyOptions& options() const { return options_; }

  Judged judge(std::uint64_t piece, std::uint64_t first_line, std::uint64_t first_record) const {
    return judge_->judge({lines(piece).text, first_line, first_record});
  }

  /// The complete lines that begin in a piece.
  PieceLines lines(std::uint64_t piece) const {
    const std::uint64_t from = begin_ + piece * piece_size_, to = std::min(from + piece_size_, size_);
    const std::uint64_t look_from = piece == 0 ? from : from - 1;  // a line begins after the end of the line before
    PieceLines result{bytes(look_from, to), false};
    std::string& text = result.text;
    if (piece > 0) text.erase(0, std::min(text.find('\n'), text.size() - 1) + 1);
    if (text.empty()) return result;  // a longer line began before this piece
    for (std::uint64_t at = to; at < size_ && text.back() != '\n'; at += more) {
      const std::string next = bytes(at, std::min(at + more, size_));
      text.append(next, 0, std::min(next.find('\n'), next.size() - 1) + 1);
      if (length_of_last(text) > max_record_line) break;
    }
    if (length_of_last(text) > max_record_line) {
      text.resize(text.size() - length_of_last(text));
      result.too_long = true;
    }
    return result;
  }

 private:
  static constexpr std::uint64_t more = 1U << 16U;

  static std::size_t length_of_last(const std::string& text) {
    const std::size_t before = text.rfind('\n', text.size() - 2);
    return text.size() < 2 || before == std::string::npos ? text.size() : text.size() - before - 1;
  }

  static InputError unreadable(const std::string& file, int error) {
    return InputError({{file, 0, 0, "cannot be read: " + std::generic_category().message(error)}});
  }

  static Descriptor opened(const std::string& file) {
    Descriptor result(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
    if (!result.open()) throw unreadable(file, errno);
    return result;
  }

  std::size_t read_at(std::uint64_t at, char* buffer, std::size_t size) const {
    while (true) {
      const ssize_t count = ::pread(file_.number(), buffer, size, static_cast<off_t>(at));
      if (count >= 0) return static_cast<std::size_t>(count);
      if (errno != EINTR) throw unreadable(options_.file, errno);
    }
  }

  std::string bytes(std::uint64_t from, std::uint64_t to) const {
    std::string result(to - from, '\0');
    for (std::size_t done = 0; done < result.size();) {
      const std::size_t count = read_at(from + done, result.data() + done, result.size() - done);
      if (count == 0) throw InputError({{options_.file, 0, 0, "found a file that became shorter while it was read"}});
      done += count;
    }
    return result;
  }

  ByteSource source() {
    return [this, at = std::uint64_t{0}](char* buffer, std::size_t size) mutable {
      const std::size_t count = read_at(at, buffer, size);
      at += count;
      return count;
    };
  }

  CertifyOptions options_;
  std::uint64_t piece_size_, size_ = 0, begin_ = 0;
  std::string changed_;
  Descriptor file_;
  ChunkReader reader_;
  std::optional<ChunkJudge> judge_;
};

RecordPieces::RecordPieces(const CertifyOptions& options, std::uint64_t piece_size)
    : file_(std::make_unique<File>(options, piece_size)) {}

RecordPieces::~RecordPieces() = default;

std::uint64_t RecordPieces::pieces() const {
  return file_->pieces();
}

std::string RecordPieces::input() const {
  return file_->input();
}

std::string RecordPieces::answer(std::string_view request, PartWriter* part) const {
  ByteReader bytes(request);
  const auto question = static_cast<PieceQuestion>(bytes.number());
  const std::uint64_t piece = bytes.number();
  if (question == PieceQuestion::count) {
    bytes.end();
    const PieceCount count = count_lines(file_->lines(piece));
    return ByteWriter().number(count.lines).number(count.records).number(count.too_long ? 1 : 0).take();
  }
  const std::uint64_t first_line = bytes.number(), first_record = bytes.number();
  bytes.end();
  Judged judged = file_->judge(piece, first_line, first_record);
  if (part != nullptr && !judged.lines.empty()) judged.lines = part->add(judged.lines).to_bytes();
  return judged_bytes(judged);
}

bool RecordPieces::stands(std::string_view request, std::string_view result, const PartSizes& parts) {
  if (static_cast<PieceQuestion>(ByteReader(request).number()) == PieceQuestion::count) return true;
  const std::string range = read_judged(result).lines;
  return range.empty() || parts.hold(PartRange::from_bytes(range));
}

/// Where each piece begins, and how many pieces can be judged: those up to a line that is too long.
class RecordPieces::Places {
 public:
  Places(const File& file, Crew& crew) : at_{{file.first_line(), 1}} {
    const auto request = [](std::uint64_t i) {
      return ByteWriter().number(static_cast<std::uint64_t>(PieceQuestion::count)).number(i).take();
    };
    crew.each(file.pieces(), request, [this](std::uint64_t, const std::string& result) {
      ByteReader bytes(result);
      const std::uint64_t lines = bytes.number(), records = bytes.number();
      if (!too_long_) at_.emplace_back(at_.back().first + lines, at_.back().second + records);
      too_long_ = too_long_ || bytes.number() != 0;
    });
  }

  std::uint64_t pieces() const { return at_.size() - 1; }
  bool too_long() const { return too_long_; }
  std::uint64_t last_line() const { return at_.back().first; }
  std::string request(std::uint64_t piece) const {
    const auto& [line, record] = at_[piece];
    return ByteWriter()
        .number(static_cast<std::uint64_t>(PieceQuestion::judge))
        .number(piece)
        .number(line)
        .number(record)
        .take();
  }

 private:
  std::vector<std::pair<std::uint64_t, std::uint64_t>> at_;  ///< line and record
  bool too_long_ = false;
};

CertifySummary RecordPieces::certify(Crew& crew, const LineSink& output, const Progress& progress) const {
  const Places places(*file_, crew);
  const CertifyOptions& options = file_->options();
  CertifySummary summary;
  crew.each(
      places.pieces(), [&](std::uint64_t i) { return places.request(i); },
      [&](std::uint64_t, const std::string& result) {
        write_judged(read_judged(result), summary, options, output, progress);
      });
  if (places.too_long()) throw too_long_line(options.file, places.last_line());
  return summary;
}

}  // namespace slipproof
