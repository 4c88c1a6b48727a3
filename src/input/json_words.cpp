#include "input/json_words.hpp"

#include <algorithm>
#include <array>

namespace slipproof {

namespace {

constexpr std::array<std::string_view, 3> words{"NaN", "Infinity", "-Infinity"};

/// The end of the text that begins at a quotation mark; of the line, where it does not end.
std::size_t end_of_text(std::string_view line, std::size_t at) {
  for (++at; at < line.size() && line[at] != '"'; ++at) {
    if (line[at] == '\\') ++at;
  }
  return std::min(at + 1, line.size());
}

}  // namespace

JsonLine without_words(std::string_view line) {
  JsonLine result{std::string(line), {}};
  for (std::size_t at = 0; at < line.size();) {
    if (line[at] == '"') {
      result.texts.emplace_back();
      at = end_of_text(line, at);
      continue;
    }
    const auto* const word = std::find_if(words.begin(), words.end(), [&](std::string_view w) {
      return line[at] == w[0] && line.substr(at, w.size()) == w;
    });
    if (word == words.end()) {
      ++at;
      continue;
    }
    result.texts.push_back({line.substr(at, word->size()), at + 1});
    result.text[at] = result.text[at + word->size() - 1] = '"';
    at += word->size();
  }
  return result;
}

}  // namespace slipproof
