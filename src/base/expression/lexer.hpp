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
  std::size_t column = 1;  ///< of its first byte, from 1
};

/// For a message: `b1`, the end, ...; a character beyond ASCII with what to write for
/// it; bytes that are no character by their number.
std::string describe(const Token& token);

/// One token at a time. A number is as long as what could belong to one, so that `2b` is one (malformed) token.
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
