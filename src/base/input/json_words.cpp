#include "base/input/json_words.hpp"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace slipproof {

namespace {

constexpr std::array<std::string_view, 3> words{"NaN", "Infinity", "-Infinity"};

/// The end of the text that begins at a quotation mark; the end of the line if it is not closed.
std::size_t end_of_text(std::string_view line, std::size_t at) {
  for (++at; at < line.size() && line[at] != '"'; ++at) {
    if (line[at] == '\\') ++at;
  }
  return std::min(at + 1, line.size());
}

/// The end of a run of characters that numbers consist of.
std::size_t end_of_number(std::string_view line, std::size_t at) {
  return std::min(line.find_first_not_of("0123456789.eE+-", at), line.size());
}

/// Whether it is a number beyond binary64's range, which nlohmann's reader takes for no JSON.
bool is_beyond_binary64(std::string_view number) {
  constexpr std::size_t digits_within = 308;
  if (number.size() <= digits_within && number.find_first_of("eE") == std::string_view::npos) return false;
  double value = 0;
  const auto [end, error] = fast_float::from_chars(number.data(), number.data() + number.size(), value);
  const bool read = error == std::errc() || error == std::errc::result_out_of_range;
  return read && end == number.data() + number.size() && std::isinf(value);
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
    std::size_t end = at + 1;
    if (word != words.end()) {
      end = at + word->size();
    } else if (line[at] == '-' || (line[at] >= '0' && line[at] <= '9')) {
      end = end_of_number(line, at);
      if (!is_beyond_binary64(line.substr(at, end - at))) {
        at = end;
        continue;
      }
    } else {
      ++at;
      continue;
    }
    result.texts.push_back({line.substr(at, end - at), at + 1});
    result.text[at] = result.text[end - 1] = '"';
    at = end;
  }
  return result;
}

}  // namespace slipproof
