// Reading statements and certificates: lines, their tokens, and what happens if they are not as they should be.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cstdint>
#include <istream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace slipproof::check {

inline constexpr std::size_t kMaxLine = 1 << 20, kMaxName = 100;
inline constexpr int kMaxExponent = 64;
inline constexpr int kMaxNesting = 100;  ///< of brackets, of formulas, and of branches

/// The text breaks a rule of proofs/FORMAT.md, or exceeds one of the limits that are listed there.
struct Rejection : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline void require(bool condition, const char* otherwise) {
  if (!condition) throw Rejection(otherwise);
}

/// A place in a text: a line, and a token in it.
class Reader {
 public:
  explicit Reader(std::istream& input, std::string file = "") : input_(input), file_(std::move(file)) {}
  std::istream& input() const { return input_; }

  /// Goes to the next line that is neither empty nor a comment; false if there is none.
  bool next_line() {
    do {
      line_.clear();
      tokens_.clear();
      next_ = 0;
      ++number_;
      if (input_.peek() == std::istream::traits_type::eof()) return false;
      for (char c; input_.get(c) && c != '\n'; line_ += c) require(line_.size() < kMaxLine, "the line is too long");
      find_tokens();
    } while (at_end() || peek() == "#");
    for (const char c : line_ + '\n') fingerprint_ = (fingerprint_ ^ static_cast<unsigned char>(c)) * 1099511628211U;
    return true;
  }

  void need_line() { require(next_line(), "the file ends too early"); }

  /// FNV-1a of the lines so far that count, in hexadecimal.
  std::string fingerprint() const {
    const std::string digits = mpz_class(fingerprint_).get_str(16);
    return std::string(16 - digits.size(), '0') + digits;
  }

  bool at_end() const { return next_ == tokens_.size(); }  ///< of the line
  void expect_end() const { require(at_end(), "expected the end of the line"); }
  std::string_view peek() const { return at_end() ? "" : tokens_[next_]; }
  std::string take() { return std::string(tokens_.at(next_++)); }

  /// Goes past the next token if it is this one.
  bool accept(std::string_view token) {
    if (peek() != token) return false;
    ++next_;
    return true;
  }

  void expect(std::string_view token) {
    if (!accept(token)) throw Rejection("expected '" + std::string(token) + "'");
  }

  void expect_line(const std::string& text) {
    need_line();
    if (line_ != text) throw Rejection("expected '" + text + "'");
  }

  std::string name() {
    require(!at_end() && is_letter(peek().front()) && peek().size() <= kMaxName, "expected a name");
    return take();
  }

  mpz_class number() {
    require(!at_end() && std::all_of(peek().begin(), peek().end(), is_digit), "expected a number or a known name");
    require(peek() == "0" || peek().front() != '0', "a number begins with zero");
    return mpz_class(take(), 10);
  }

  int exponent() {
    const mpz_class result = number();
    require(result >= 1 && result <= kMaxExponent, "an exponent is out of range");
    return static_cast<int>(result.get_si());
  }

  std::string rule = "header";  ///< what is being read
  std::string place() const { return file_ + ":" + std::to_string(number_) + ": " + rule + ": "; }

 private:
  static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  static bool is_in_word(char c) { return is_letter(c) || is_digit(c) || c == '_' || c == '\'' || c == '.'; }

  /// Tokens are words, of all characters that names and numbers may have, the signs <=, >=, !=, and single characters.
  void find_tokens() {
    for (std::string_view rest = line_; !rest.empty();) {
      const auto end = std::find_if_not(rest.begin(), rest.end(), is_in_word);
      std::size_t size = std::max<std::size_t>(1, static_cast<std::size_t>(end - rest.begin()));
      if (rest.size() > 1 && rest[1] == '=' && std::string_view("<>!").find(rest[0]) < 3) size = 2;
      if (rest.front() != ' ' && rest.front() != '\t') tokens_.push_back(rest.substr(0, size));
      rest.remove_prefix(size);
    }
  }

  std::istream& input_;
  std::string file_, line_;
  std::vector<std::string_view> tokens_;
  std::size_t next_ = 0, number_ = 0;  ///< of the token, of the line
  std::uint64_t fingerprint_ = 14695981039346656037U;
};

}  // namespace slipproof::check
