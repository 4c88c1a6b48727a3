// Reads a stream of lines in pieces of bounded size.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "base/input/byte_source.hpp"
#include "base/input/diagnostic.hpp"

namespace slipproof {

/// Whole lines and their position.
struct Chunk {
  std::string text;
  std::uint64_t first_line = 0, first_record = 0;
};

/// True for a blank line, which is not a record.
inline bool blank(std::string_view line) {
  if (!line.empty() && line.front() > ' ') return false;  // nearly always
  return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

/// Calls see(line) for each line of a text.
template <class See>
void each_line(std::string_view text, const See& see) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    see(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

/// The error for a line longer than max_record_line.
InputError too_long_line(const std::string& file, std::uint64_t line);

/// A chunk ends where the source has no more bytes yet, so that a client that waits for an answer before it sends the
/// next line gets it. Throws InputError for a line longer than max_record_line and for a source that cannot be read.
class ChunkReader {
 public:
  ChunkReader(ByteSource source, std::string file) : source_(std::move(source)), file_(std::move(file)) {}

  /// The first byte that is not blank, without consuming it; 0 at the end of the input.
  char first();
  /// Whether the input begins with this text, without consuming it.
  bool begins_with(std::string_view text);

  /// The first line that is not blank, without its line end; empty at the end of the input.
  std::string header();

  /// The position of the next chunk: bytes from the beginning, and the number of its first line.
  std::uint64_t offset() const { return filled_ - rest_.size(); }
  std::uint64_t line() const { return line_; }

  /// Reads the next chunk; false at the end of the input. A chunk that is used again keeps its memory.
  bool next(Chunk& chunk);

 private:
  bool fill(std::string& text);

  ByteSource source_;
  std::string file_, rest_;  ///< `rest_`: read, but not yet returned
  std::uint64_t line_ = 1, record_ = 1, filled_ = 0;
  bool at_end_ = false;
};

}  // namespace slipproof
