#include "base/input/toml_guard.hpp"

#include <cstddef>
#include <string>

#include "base/input/utf8.hpp"

namespace slipproof {

namespace {

/// Far more than a legible file needs; together with the limit on nested values it bounds the depth of tables.
constexpr int max_key_parts = 16;

class Guard {
 public:
  Guard(std::string_view text, Mistakes& mistakes) : text_(text), mistakes_(mistakes) {}

  bool passes() {
    while (ok_ && position_ < text_.size()) {
      const char c = text_[position_];
      if (c == '#') {
        while (ok_ && position_ < text_.size() && text_[position_] != '\n') advance();
      } else if (c == '"' || c == '\'') {
        pass_string(c);
      } else {
        if (c == '=' || c == ',' || c == '\n' || c == '[' || c == ']' || c == '{' || c == '}') key_parts_ = 1;
        if (c == '.' && ++key_parts_ > max_key_parts) {
          refuse("found a key of more than " + std::to_string(max_key_parts) + " parts, expected a shorter one");
        } else {
          advance();
        }
      }
    }
    return ok_;
  }

 private:
  void pass_string(char quote) {
    const bool multi_line = text_.substr(position_, 3) == std::string(3, quote);
    for (int i = 0; i < (multi_line ? 3 : 1); ++i) advance();
    while (ok_ && position_ < text_.size()) {
      const char c = text_[position_];
      if (c == quote) {
        std::size_t run = 0;
        while (run < 5 && position_ + run < text_.size() && text_[position_ + run] == quote) ++run;
        if (!multi_line) run = 1;
        for (std::size_t i = 0; i < run; ++i) advance();
        if (!multi_line || run >= 3) return;
      } else if (c == '\n' && !multi_line) {
        return;  // toml++ reports it
      } else if (c == '\\' && quote == '"') {
        advance();
        if (ok_ && position_ < text_.size()) advance();
      } else {
        advance();
      }
    }
  }

  /// One character on.
  void advance() {
    const std::size_t length = utf8_length(text_.substr(position_));
    if (length == 0) {
      constexpr std::string_view hex = "0123456789abcdef";
      const auto byte = static_cast<unsigned char>(text_[position_]);
      refuse(std::string("found the byte 0x") + hex[byte >> 4] + hex[byte & 15] + ", expected UTF-8 text");
      return;
    }
    if (text_[position_] == '\n') {
      place_ = {place_.line + 1, 1};
    } else {
      ++place_.column;
    }
    position_ += length;
  }

  void refuse(std::string message) {
    mistakes_.add(place_, std::move(message));
    ok_ = false;
  }

  std::string_view text_;
  Mistakes& mistakes_;
  std::size_t position_ = 0;
  Place place_{1, 1};
  int key_parts_ = 1;
  bool ok_ = true;
};

}  // namespace

bool fit_for_tomlplusplus(std::string_view text, Mistakes& mistakes) {
  return Guard(text, mistakes).passes();
}

}  // namespace slipproof
