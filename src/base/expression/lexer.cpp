#include "base/expression/lexer.hpp"

#include <algorithm>
#include <array>

#include "base/input/look_alikes.hpp"
#include "base/input/utf8.hpp"

namespace slipproof {

namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

// `1e-3` and `0x1p-3` hold their sign; in `0xe-3` the e is a digit and the sign an operator.
std::size_t number_length(std::string_view text) {
  const bool hexadecimal = text.size() > 1 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
  std::size_t length = 0;
  while (length < text.size()) {
    const char c = text[length];
    const char before = length == 0 ? '0' : text[length - 1];
    const bool after_exponent = hexadecimal ? before == 'p' || before == 'P' : before == 'e' || before == 'E';
    if (!is_digit(c) && !is_letter(c) && c != '.' && !(after_exponent && (c == '+' || c == '-'))) break;
    ++length;
  }
  return length;
}

constexpr std::array<std::string_view, 4> two_characters{"<=", ">=", "!=", "=="};
constexpr std::string_view one_character = "+-*/^()<>=,";

}  // namespace

void Lexer::advance() {
  while (position_ < text_.size() && is_space(text_[position_])) ++position_;
  const std::string_view rest = text_.substr(position_);
  token_ = {Token::Kind::end, rest.substr(0, 0), position_ + 1};
  if (rest.empty()) return;
  std::size_t length = 1;
  if (is_digit(rest[0]) || (rest[0] == '.' && rest.size() > 1 && is_digit(rest[1]))) {
    token_.kind = Token::Kind::number;
    length = number_length(rest);
  } else if (is_letter(rest[0])) {
    token_.kind = Token::Kind::word;
    while (length < rest.size() && (is_letter(rest[length]) || is_digit(rest[length]))) ++length;
  } else if (std::find(two_characters.begin(), two_characters.end(), rest.substr(0, 2)) != two_characters.end()) {
    token_.kind = Token::Kind::punctuation;
    length = 2;
  } else {
    token_.kind = one_character.find(rest[0]) == one_character.npos ? Token::Kind::unknown : Token::Kind::punctuation;
    if (token_.kind == Token::Kind::unknown) length = std::max<std::size_t>(1, utf8_length(rest));
  }
  token_.text = rest.substr(0, length);
  position_ += length;
}

std::string describe(const Token& token) {
  if (token.kind == Token::Kind::end) return "the end";
  if (const auto odd = first_odd_character(token.text)) return describe(*odd);
  const auto c = static_cast<unsigned char>(token.text.front());
  if (token.kind == Token::Kind::unknown && (c < 0x20 || c > 0x7e)) return "a byte of value " + std::to_string(c);
  constexpr std::size_t shown = 40;
  if (token.text.size() > shown) return "`" + std::string(token.text.substr(0, shown)) + "...`";
  return "`" + std::string(token.text) + "`";
}

}  // namespace slipproof
