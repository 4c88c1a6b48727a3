// The text of a certificate as tokens, and the errors for malformed text.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "proofs/check_contact/number.hpp"

namespace slipproof::check_contact {

inline constexpr std::size_t kMaxShown = 40;  ///< characters of a token in a message

/// The name of a problem.
inline bool is_name(std::string_view text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// The text is no certificate.
struct Unreadable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

using Vector = std::vector<Number>;
using Row = std::map<std::size_t, Number>;  ///< column -> entry; the others are 0
using Matrix = std::vector<Row>;
using Indices = std::set<std::size_t>;

/// Reads token by token. What is not as it should be is Unreadable, with its place.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) { advance(); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  /// Goes past the next token if it is this one.
  bool accept(std::string_view word) {
    if (token_ != word) return false;
    advance();
    return true;
  }

  void expect(std::string_view word) {
    if (!accept(word)) refuse("'" + std::string(word) + "'");
  }

  /// How many of something follow.
  std::size_t count() {
    const std::size_t most = text_.size() / 2;
    return below(most + 1, Indices{}, "a count of at most " + std::to_string(most) + ", half the size of the file");
  }

  /// So many numbers are to come, each a digit and a blank at least: so memory is bounded by the size of the file.
  void announce(std::size_t numbers) const {
    if (numbers > text_.size() / 2) refuse("a file that is long enough for " + std::to_string(numbers) + " numbers");
  }

  template <class Taken = Indices>
  std::size_t index(std::size_t size, const Taken& taken = {}) {
    return below(size, taken, "an index below " + std::to_string(size));
  }

  Number number() {
    const auto value = check_contact::number(token_);
    if (!value) refuse("an exact number");
    advance();
    return *value;
  }

  /// A SHA-256.
  std::string name() {
    if (!is_name(token_)) refuse("64 hexadecimal digits");
    std::string result(token_);
    advance();
    return result;
  }

  Vector numbers(std::size_t size) {
    Vector result;
    while (result.size() < size) result.push_back(number());
    return result;
  }
  Vector numbers(std::string_view word, std::size_t size) {
    expect(word);
    return numbers(size);
  }

  /// Column and number.
  void entry(Row& row, std::size_t columns) {
    const std::size_t column = below(columns, row, "an index below " + std::to_string(columns));
    row.emplace(column, number());
  }

  /// How many, and so many entries: row, column and number.
  Matrix entries(std::size_t rows, std::size_t columns) {
    Matrix result(rows);
    for (std::size_t left = count(); left > 0; --left) {
      entry(result[index(rows)], columns);
    }
    return result;
  }
  Matrix entries(std::string_view word, std::size_t rows, std::size_t columns) {
    expect(word);
    return entries(rows, columns);
  }

  bool at(std::string_view word) const { return token_ == word; }

  void finish() {
    expect("end");
    if (!token_.empty()) refuse("nothing after 'end'");
  }

  [[noreturn]] void refuse(const std::string& expected) const {
    std::string found = "the end of the file";
    if (!token_.empty()) found = "'" + std::string(token_.substr(0, kMaxShown)) + "'";
    if (token_.size() > kMaxShown) found += "...";
    throw Unreadable(place_ + "found " + found + ", expected " + expected);
  }

 private:
  template <class Taken>
  std::size_t below(std::size_t end, const Taken& taken, const std::string& expected) {
    const auto found = token_.size() < 20 ? natural(token_) : std::nullopt;
    if (!found || *found >= end) refuse(expected);
    if (taken.count(found->get_ui()) > 0) refuse("an index that does not stand here already");
    advance();
    return found->get_ui();
  }

  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n'; }
  std::string place() const { return "line " + std::to_string(line_) + ", column " + std::to_string(column_) + ": "; }

  /// Goes past blanks and comments to the next token.
  void advance() {
    for (bool comment = false; at_ < text_.size() && (comment || is_blank(text_[at_]) || text_[at_] == '#'); step()) {
      comment = text_[at_] == '#' || (comment && text_[at_] != '\n');
    }
    place_ = place();
    const std::size_t start = at_;
    while (at_ < text_.size() && !is_blank(text_[at_]) && text_[at_] != '#') step();
    token_ = text_.substr(start, at_ - start);
  }

  /// Past a byte. What an editor does not show is refused, in comments as well.
  void step() {
    const char byte = text_[at_];
    if (!is_blank(byte) && (byte < ' ' || byte > '~')) {
      throw Unreadable(place() + "found a byte of value " + std::to_string(static_cast<unsigned char>(byte)) +
                       ", expected printable ASCII");
    }
    ++at_;
    ++column_;
    if (byte == '\n') ++line_, column_ = 1;
  }

  const std::string_view text_;
  std::size_t at_ = 0, line_ = 1, column_ = 1;  ///< of the next byte to read
  std::string_view token_;                      ///< empty at the end of the file
  std::string place_;                           ///< of the token
};

}  // namespace slipproof::check_contact
