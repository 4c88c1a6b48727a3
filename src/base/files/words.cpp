#include "base/files/words.hpp"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/input/utf8.hpp"

namespace slipproof {

namespace {

constexpr std::string_view blanks = " \t\n\r\f\v";

}  // namespace

std::optional<double> read_binary64(std::string_view word) {
  if (word.starts_with('+') && word.size() > 1 && word[1] != '-' && word[1] != '+') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = fast_float::from_chars(word.data(), word.data() + word.size(), value);
  // Out of range, the value is still the nearest one: 0 or an infinity.
  const bool read = error == std::errc() || error == std::errc::result_out_of_range;
  if (word.empty() || !read || end != word.data() + word.size()) return std::nullopt;
  return value;
}

Place place_in(std::string_view text, std::size_t position) {
  const std::string_view before = text.substr(0, position);
  const std::size_t line_end = before.rfind('\n');
  const std::size_t start = line_end == std::string_view::npos ? 0 : line_end + 1;
  return {1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')),
          1 + utf8_count(before.substr(start))};
}

void refuse(const std::string& file, std::string_view text, const FormatStop& stop) {
  const Place place = place_in(text, stop.position);
  throw InputError({Diagnostic{file, place.line, place.column, stop.message}});
}

void refuse(const std::string& file, const std::string& message) {
  throw InputError({Diagnostic{.file = file, .message = message}});
}

void refuse_more(const std::string& file, const std::string& where, std::uint64_t found,
                 std::optional<std::size_t> expected) {
  if (!expected || found <= *expected) return;
  refuse(file, where + "found " + std::to_string(found) + " numbers, expected " + std::to_string(*expected));
}

std::size_t WordReader::position() {
  position_ = std::min(text_.find_first_not_of(blanks, position_), text_.size());
  return position_;
}

std::string_view WordReader::peek() {
  const std::size_t start = position();
  return text_.substr(start, std::min(text_.find_first_of(blanks, start), text_.size()) - start);
}

std::string_view WordReader::next() {
  const std::string_view word = peek();
  position_ += word.size();
  return word;
}

std::string_view WordReader::rest_of_line() {
  const std::size_t end = std::min(text_.find('\n', position_), text_.size());
  const std::string_view line = text_.substr(position_, end - position_);
  position_ = std::min(end + 1, text_.size());
  return line;
}

void WordReader::stop(const std::string& expected) {
  const std::string_view word = peek();
  throw FormatStop{position(), "found " + (word.empty() ? std::string("the end of the file") : in_quotes(word)) +
                                   ", expected " + expected};
}

std::size_t WordReader::count(std::string_view expected) {
  const std::string_view word = peek();
  const bool digits = !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos;
  if (!digits) stop(std::string(expected));
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || value > text_.size()) {
    stop(std::string(expected) + ", of which a file of " + std::to_string(text_.size()) + " bytes cannot have more");
  }
  next();
  return value;
}

double WordReader::number(std::string_view expected) {
  const std::optional<double> value = read_binary64(peek());
  if (!value) stop(std::string(expected));
  next();
  return *value;
}

double WordReader::finite_number(std::string_view expected) {
  const std::optional<double> value = read_binary64(peek());
  if (!value) stop(std::string(expected));
  if (!std::isfinite(*value)) stop(std::string(expected) + ", finite and within binary64's range");
  next();
  return *value;
}

void WordReader::word(std::string_view expected) {
  if (peek() != expected) stop(in_quotes(expected));
  next();
}

}  // namespace slipproof
