#include "base/number/parse.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "base/number/flint_memory.hpp"

namespace slipproof {

NumberError::NumberError(std::size_t position, std::string found, std::string expected)
    : std::runtime_error("found " + found + ", expected " + expected),
      position_(position),
      found_(std::move(found)),
      expected_(std::move(expected)) {}

namespace {

bool is_digit(char c, int base) {
  return base == 16 ? std::isxdigit(static_cast<unsigned char>(c)) != 0 : c >= '0' && c <= '9';
}

/// Digits with at most one point among them: the value is `digits` read in its base, times base^-fraction_digits.
struct Significand {
  std::string digits;
  int fraction_digits = 0;
  bool has_point = false;
};

class NumberReader {
 public:
  explicit NumberReader(std::string_view text) : text_(text) {}

  Rational read() {
    if (text_.empty()) throw NumberError(0, "nothing", "a number");
    if (text_.size() > max_number_length) {
      throw NumberError(0, std::to_string(text_.size()) + " characters",
                        "at most " + std::to_string(max_number_length) + " in a number");
    }
    const bool negative = peek() == '-';
    if (negative || peek() == '+') ++position_;
    refuse_word();
    const bool hexadecimal = peek() == '0' && (peek(1) == 'x' || peek(1) == 'X');
    if (hexadecimal) position_ += 2;
    Rational value = hexadecimal ? read_hexadecimal() : read_decimal();
    if (position_ != text_.size()) refuse(hexadecimal ? "the end of the hexadecimal number" : "the end of the number");
    return negative ? Rational(-value) : value;
  }

 private:
  char peek(std::size_t ahead = 0) const { return position_ + ahead < text_.size() ? text_[position_ + ahead] : '\0'; }

  Rational read_decimal() {
    const Significand significand = read_significand(10);
    if (peek() == '/') return read_fraction(significand);
    const bool has_exponent = peek() == 'e' || peek() == 'E';
    const int exponent = has_exponent ? read_exponent(max_decimal_exponent) : 0;
    if (peek() == '/') refuse_fraction();
    const Integer digits(significand.digits);
    const int scale = exponent - significand.fraction_digits;
    const Integer power = pow(Integer(10), static_cast<unsigned>(std::abs(scale)));
    return scale < 0 ? Rational(digits, power) : Rational(digits * power);
  }

  Rational read_hexadecimal() {
    const Significand significand = read_significand(16);
    const bool has_exponent = peek() == 'p' || peek() == 'P';
    const int exponent = has_exponent ? read_exponent(max_binary_exponent) : 0;
    if (peek() == '/') refuse_fraction();
    return times_power_of_two(Integer(significand.digits, 16), exponent - 4 * significand.fraction_digits);
  }

  Rational read_fraction(const Significand& numerator) {
    if (numerator.has_point) refuse_fraction();
    ++position_;
    if (peek() == '-' || peek() == '+') {
      throw NumberError(position_, "a sign in the denominator", "the sign in front of the fraction");
    }
    const std::size_t start = position_;
    const Significand denominator = read_significand(10);
    if (denominator.has_point || peek() == 'e' || peek() == 'E' || peek() == 'x' || peek() == 'X') {
      throw NumberError(start, "a denominator that is not an integer", "a fraction of two integers, such as 3/4");
    }
    if (denominator.digits.find_first_not_of('0') == std::string::npos) {
      throw NumberError(start, "a zero denominator", "a denominator other than 0");
    }
    return {Integer(numerator.digits), Integer(denominator.digits)};
  }

  /// At least one digit, at most one point, leading zeros dropped.
  Significand read_significand(int base) {
    Significand significand;
    bool any_digit = false;
    for (;; ++position_) {
      if (is_digit(peek(), base)) {
        any_digit = true;
        significand.digits += peek();
        if (significand.has_point) ++significand.fraction_digits;
      } else if (peek() == '.' && !significand.has_point) {
        significand.has_point = true;
      } else {
        break;
      }
    }
    if (!any_digit) refuse(base == 16 ? "a hexadecimal digit" : "a digit");
    significand.digits.erase(0, std::min(significand.digits.find_first_not_of('0'), significand.digits.size() - 1));
    return significand;
  }

  int read_exponent(int limit) {
    const std::size_t start = ++position_;
    const bool negative = peek() == '-';
    if (negative || peek() == '+') ++position_;
    if (!is_digit(peek(), 10)) refuse("a digit of the exponent");
    int magnitude = 0;
    for (; is_digit(peek(), 10); ++position_) magnitude = std::min(10 * magnitude + (peek() - '0'), limit + 1);
    if (magnitude > limit) {
      std::string found(text_.substr(start, position_ - start));
      if (found.size() > 24) found = found.substr(0, 20) + "...";
      throw NumberError(start, "the exponent " + found,
                        "one from -" + std::to_string(limit) + " to " + std::to_string(limit));
    }
    return negative ? -magnitude : magnitude;
  }

  /// NaN and the infinities in the spellings that programs print.
  void refuse_word() const {
    std::string word(text_.substr(position_));
    for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (word == "nan" || word.starts_with("nan(")) throw NumberError(position_, "NaN", "a finite number");
    if (word == "inf" || word == "infinity") throw NumberError(position_, "infinity", "a finite number");
  }

  [[noreturn]] void refuse_fraction() const {
    throw NumberError(position_, "a '/' after a number that is not a decimal integer",
                      "a fraction of two integers, such as 3/4");
  }

  /// Reports an unexpected character at the position; the usual slips get messages of their own.
  [[noreturn]] void refuse(const std::string& expected) const {
    if (position_ >= text_.size()) throw NumberError(position_, "the end of the text", expected);
    switch (peek()) {
      case '_':
        throw NumberError(position_, "'_'", "digits without separators");
      case ',':
        throw NumberError(position_, "','", "'.' as the decimal point, and no separators");
      case ' ':
      case '\t':
      case '\n':
      case '\r':
        throw NumberError(position_, "a space", "a number without spaces");
      default:
        throw NumberError(position_, character(), expected);
    }
  }

  /// The character at the position, as a message may show it: printable ASCII and whole UTF-8 sequences as they are.
  std::string character() const {
    const auto byte = static_cast<unsigned char>(peek());
    if (byte > 0x20 && byte < 0x7f) return "'" + std::string(1, peek()) + "'";
    const std::size_t length = byte >= 0xf0 && byte < 0xf8 ? 4 : byte >= 0xe0 ? 3 : byte >= 0xc2 ? 2 : 1;
    std::size_t following = 0;
    while (following + 1 < length && (static_cast<unsigned char>(peek(following + 1)) & 0xc0) == 0x80) ++following;
    if (length > 1 && byte < 0xf8 && following + 1 == length) {
      return "'" + std::string(text_.substr(position_, length)) + "'";
    }
    constexpr std::string_view hex = "0123456789abcdef";
    return std::string("the byte 0x") + hex[byte >> 4] + hex[byte & 15];
  }

  std::string_view text_;
  std::size_t position_ = 0;
};

}  // namespace

Rational parse_rational(std::string_view text) {
  give_back_flint_memory_at_end();
  return NumberReader(text).read();
}

}  // namespace slipproof
