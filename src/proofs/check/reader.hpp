// Reading statements and certificates: lines, their tokens, and what happens if they are not as they should be.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace slipproof::check {

inline constexpr std::size_t kMaxLine = 1 << 20, kMaxName = 100;
inline constexpr std::size_t kMaxWork = 50'000'000;
inline constexpr int kMaxExponent = 64;
inline constexpr int kMaxNesting = 100;  ///< of brackets, of formulas, and of branches

/// The text breaks a rule of proofs/FORMAT.md, or exceeds one of the limits that are listed there.
struct Rejection : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline void require(bool condition, const char* otherwise) {
  if (!condition) throw Rejection(otherwise);
}

/// The cost of a statement or a proof so far: bytes read, polynomials and terms made, divisors compared, and long
/// multiplications. It is bounded, so every check ends soon. A new object starts at zero.
class Work {
 public:
  Work() { done = 0; }
  static void spend(std::size_t amount) { require((done += amount) <= kMaxWork, "checking takes too much work"); }

 private:
  inline static thread_local std::size_t done = 0;
};

/// A place in a text: a line, and a token in it.
class Reader {
 public:
  explicit Reader(std::string text) : text_(std::move(text)) {}
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  std::size_t size() const { return text_.size(); }  ///< in bytes, of the text

  /// Goes to the next line that is neither empty nor a comment; false if there is none.
  bool next_line() {
    do {
      tokens_.clear();
      next_ = 0;
      ++number_;
      const std::size_t end = std::min(text_.find('\n', start_), text_.size());
      line_ = std::string_view(text_).substr(start_, end - start_);
      if (start_ == text_.size()) return false;
      start_ = std::min(end + 1, text_.size());
      find_tokens();
    } while (at_end() || peek() == "#");
    for (const char c : line_) add_to_fingerprint(c);
    add_to_fingerprint('\n');
    return true;
  }

  void need_line() { require(next_line(), "the file ends too early"); }

  /// FNV-1a of the lines so far that count, in hexadecimal.
  std::string fingerprint() const {
    const std::string digits = mpz_class(fingerprint_).get_str(16);
    return std::string(16 - digits.size(), '0') + digits;
  }

  std::string_view line() const { return line_; }
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

  /// The line `theorem NAME`. Such a name may begin with a digit, and contain `-`.
  std::string theorem() {
    need_line();
    require(line_.starts_with("theorem "), "expected 'theorem' and a name");
    const std::string_view name = line_.substr(std::string_view("theorem ").size());
    const auto allowed = [](char c) { return is_in_word(c) || c == '-'; };
    require(!name.empty() && (is_letter(name.front()) || is_digit(name.front())) && name.size() <= kMaxName &&
                std::all_of(name.begin(), name.end(), allowed),
            "expected 'theorem' and a name");
    return std::string(name);
  }

  std::string name() {
    require(!at_end() && is_letter(peek().front()) && peek().size() <= kMaxName, "expected a name");
    require(peek() != "and" && peek() != "or" && peek() != "false", "expected a name, found a reserved word");
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

  /// `LINE: RULE: `; where a byte is refused, `LINE:COLUMN: text: `.
  std::string place() const {
    const std::string column = column_ > 0 ? ":" + std::to_string(column_) : "";
    return std::to_string(number_) + column + ": " + (column_ > 0 ? "text" : rule) + ": ";
  }

 private:
  static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  static bool is_in_word(char c) { return is_letter(c) || is_digit(c) || c == '_' || c == '\'' || c == '.'; }

  /// Tokens are words, of all characters that names and numbers may have, the signs <=, >=, !=, and single characters.
  void find_tokens() {
    Work::spend(line_.size() + 1);
    require(line_.size() <= kMaxLine, "the line is too long");
    refuse_invisible();
    for (std::string_view rest = line_; !rest.empty();) {
      const auto end = std::find_if_not(rest.begin(), rest.end(), is_in_word);
      std::size_t size = std::max<std::size_t>(1, static_cast<std::size_t>(end - rest.begin()));
      if (rest.size() > 1 && rest[1] == '=' && std::string_view("<>!").find(rest[0]) < 3) size = 2;
      if (rest.front() != ' ') tokens_.push_back(rest.substr(0, size));
      rest.remove_prefix(size);
    }
  }

  /// All that is not printable ASCII, also in comments: what an editor shows is what is read.
  void refuse_invisible() {
    const auto found = std::find_if(line_.begin(), line_.end(), [](char c) { return c < ' ' || c > '~'; });
    if (found == line_.end()) return;
    column_ = static_cast<std::size_t>(found - line_.begin()) + 1;
    throw Rejection("a byte of value " + std::to_string(static_cast<unsigned char>(*found)) +
                    ", expected printable ASCII");
  }

  void add_to_fingerprint(char c) { fingerprint_ = (fingerprint_ ^ static_cast<unsigned char>(c)) * 1099511628211U; }

  const std::string text_;
  std::size_t start_ = 0;  ///< of the next line, in the text
  std::string_view line_;
  std::vector<std::string_view> tokens_;
  std::size_t next_ = 0, number_ = 0, column_ = 0;  ///< of the token, of the line, of a byte that is refused
  std::uint64_t fingerprint_ = 14695981039346656037U;
};

}  // namespace slipproof::check
