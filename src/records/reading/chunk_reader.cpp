#include "records/reading/chunk_reader.hpp"

#include "records/reading/options.hpp"

namespace slipproof {

namespace {

constexpr std::size_t chunk_size = 1U << 18U;

}  // namespace

InputError too_long_line(const std::string& file, std::uint64_t line) {
  return InputError({{file, static_cast<std::size_t>(line), 0,
                      "found a line of more than " + std::to_string(max_record_line) + " bytes, expected a record"}});
}

char ChunkReader::first() {
  constexpr std::string_view blanks = "\xEF\xBB\xBF \t\r\n";  // includes the UTF-8 byte order mark
  while (rest_.find_first_not_of(blanks) == std::string::npos && fill(rest_)) {
  }
  const std::size_t at = rest_.find_first_not_of(blanks);
  return at == std::string::npos ? '\0' : rest_[at];
}

bool ChunkReader::begins_with(std::string_view text) {
  while (rest_.size() < text.size() && text.starts_with(rest_) && fill(rest_)) {
  }
  return rest_.starts_with(text);
}

std::string ChunkReader::header() {
  std::string line;
  while (blank(line)) {
    while (rest_.find('\n') == std::string::npos && fill(rest_)) {
    }
    if (rest_.empty()) return {};
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line = rest_.substr(0, end);
    rest_.erase(0, std::min(end + 1, rest_.size()));
    ++line_;
  }
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

bool ChunkReader::next(Chunk& chunk) {
  std::string& text = chunk.text;
  text = rest_;
  rest_.clear();
  std::size_t cut = text.rfind('\n');
  while (cut == std::string::npos && fill(text)) cut = text.rfind('\n');
  if (text.empty()) return false;
  if (!at_end_) {
    rest_.assign(text, cut + 1);
    text.resize(cut + 1);
  }
  chunk.first_line = line_;
  chunk.first_record = record_;
  each_line(text, [&](std::string_view line) {
    ++line_;
    if (!blank(line)) ++record_;
  });
  return true;
}

/// Reads more input; false at the end.
bool ChunkReader::fill(std::string& text) {
  if (at_end_) return false;
  const std::size_t size = text.size(), newline = text.rfind('\n');
  if (size - (newline == std::string::npos ? 0 : newline) > max_record_line) throw too_long_line(file_, line_);
  text.resize(size + chunk_size);
  const std::size_t count = source_(text.data() + size, chunk_size);
  text.resize(size + count);
  filled_ += count;
  at_end_ = count == 0;
  return !at_end_;
}

}  // namespace slipproof
