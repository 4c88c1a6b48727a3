// What Python's json writes and no other reads: NaN, Infinity and -Infinity; and numbers beyond binary64's range.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace slipproof {

/// One of the words or of those numbers, and the byte of the line at which it stands, from 1.
struct JsonWord {
  std::string_view text;
  std::size_t column = 0;
};

/// A line in which the words are texts of the same length, so that it can be read as JSON and every place stays.
struct JsonLine {
  std::string text;
  std::vector<JsonWord> texts;  ///< for each text of the line, keys too, in order: the word that it stands for, if any
};

/// `line` must outlive the result.
JsonLine without_words(std::string_view line);

}  // namespace slipproof
