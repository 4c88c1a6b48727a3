// What Python's json writes and no other reads: NaN, Infinity and -Infinity; and numbers beyond binary64's range.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace slipproof {

/// One of the words or of those numbers, and its byte position in the line, from 1.
struct JsonWord {
  std::string_view text;
  std::size_t column = 0;
};

/// A line with these words replaced by texts of the same length, so that it can be read as JSON and every position
/// stays.
struct JsonLine {
  std::string text;
  /// for each text of the line, keys included, in order: the word that it replaces, if any
  std::vector<JsonWord> texts;
};

/// `line` must outlive the result.
JsonLine without_words(std::string_view line);

}  // namespace slipproof
