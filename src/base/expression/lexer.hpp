// The tokens of an expression.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace slipproof {

struct Token {
  enum class Kind { end, number, word, punctuation, unknown };
  Kind kind = Kind::end;
  std::string_view text;
  std::size_t column = 1;  ///< column of its first byte, from 1
};

/// Describes a token for a message: `b1`, the end, ...; for a character beyond ASCII, also what to write instead; for
/// bytes that are not UTF-8, their values.
std::string describe(const Token& token);

/// Splits a text into tokens, one at a time. A number extends over all letters, digits and points that follow, so that
/// `2b` is one (malformed) token.
class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) { advance(); }
  const Token& token() const { return token_; }
  void advance();

 private:
  std::string_view text_;
  std::size_t position_ = 0;
  Token token_;
};

}  // namespace slipproof
