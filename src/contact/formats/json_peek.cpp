// Whether a text is a contact problem, by the keys of its first object.
#include <algorithm>
#include <array>
#include <istream>

#include "contact/formats/json_problem.hpp"

namespace slipproof {

namespace {

/// Follows the keys of the first object, skipping values, until it knows.
class JsonPeek {
 public:
  /// False once nothing more is to be known.
  bool take(char c) {
    if (in_text_) {
      take_in_text(c);
      return true;
    }
    switch (c) {
      case '"':
        in_text_ = true;
        text_.clear();
        break;
      case ':':
        if (depth_ == 1) take_key();
        break;
      case '{':
      case '[':
        sparse_ = sparse_ || (c == '{' && depth_ == 1 && is_matrix());
        ++depth_;
        break;
      case '}':
      case ']':
        end_value();
        ended_ = --depth_ <= 0;
        break;
      case ',':
        end_value();
        break;
      case '\n':
        lines_ = lines_ || depth_ > 0;
        break;
      default:
        if (depth_ == 1 && key_ == "dimension" && c != ' ' && c != '\t' && c != '\r') add(value_, c);
    }
    return !ended_ && !is_problem();
  }

  bool is_problem() const { return three_ || sparse_ || law_ || (M_ && H_); }
  /// Of any dimension, and on more than one line: no line of it could be a record.
  bool is_spread_problem() const { return is_problem() || (lines_ && q_ && (W_ || M_)); }

 private:
  void take_in_text(char c) {
    if (escaped_) {
      escaped_ = false;
    } else if (c == '\\') {
      escaped_ = true;
    } else if (c == '"') {
      in_text_ = false;
      return;
    }
    add(text_, c);
  }

  /// Longer texts than those that are looked for are none of them.
  static void add(std::string& text, char c) {
    constexpr std::size_t longest = 16;
    if (text.size() < longest) text += c;
  }

  void take_key() {
    key_ = text_;
    value_.clear();
    M_ = M_ || key_ == "M";
    H_ = H_ || key_ == "H";
    W_ = W_ || key_ == "W";
    q_ = q_ || key_ == "q";
    law_ = law_ || is_of_law();
  }

  void end_value() {
    if (depth_ == 1) three_ = three_ || value_ == "3";
  }

  bool is_of_law() const {
    constexpr std::array<std::string_view, 6> keys{"law", "compliance", "bias", "bounds", "slip_speed", "units"};
    return std::ranges::find(keys, key_) != keys.end();
  }

  bool is_matrix() const {
    constexpr std::array<std::string_view, 6> matrices{"W", "M", "H", "G", "V", "R"};
    return std::ranges::find(matrices, key_) != matrices.end();
  }

  int depth_ = 0;
  bool ended_ = false, in_text_ = false, escaped_ = false, lines_ = false;
  std::string text_, key_, value_;
  bool three_ = false, sparse_ = false, M_ = false, H_ = false, W_ = false, q_ = false, law_ = false;
};

}  // namespace

bool begins_as_json_problem(std::istream& text) {
  JsonPeek peek;
  for (char c = 0; text.get(c) && peek.take(c);) {
  }
  return peek.is_spread_problem();
}

bool is_json_problem(std::string_view line) {
  const auto has = [&](std::string_view word) { return line.find(word) != std::string_view::npos; };
  // The ends of keys: quotation marks are everywhere in a line, and begin nothing that is quickly looked for.
  if (!has("dimension\"") && !has("entries\"") && !has("H\"") && !has("law\"") && !has("compliance\"") &&
      !has("bias\"") && !has("bounds\"") && !has("slip_speed\"") && !has("units\"")) {
    return false;
  }
  JsonPeek peek;
  for (const char c : line) {
    if (!peek.take(c)) break;
  }
  return peek.is_problem();
}

}  // namespace slipproof
