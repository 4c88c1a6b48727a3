#include "base/files/json_tree.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "base/files/words.hpp"
#include "base/input/utf8.hpp"

namespace slipproof {

namespace {

class JsonReader {
  static bool is_digit(char c) { return c >= '0' && c <= '9'; }

 public:
  JsonReader(std::string_view text, JsonTree& tree) : text_(text), tree_(tree) {
    if (text.starts_with("\xEF\xBB\xBF")) at_ = 3;
  }

  void read() {
    if (peek() != '{') stop_at(at_, "found " + found() + ", expected an object");
    tree_.root = value(0);
    if (peek() != '\0' || at_ < text_.size()) stop("the end");
  }

 private:
  [[noreturn]] static void stop_at(std::size_t position, std::string message) {
    throw FormatStop{position, std::move(message)};
  }
  [[noreturn]] void stop(const std::string& expected) const {
    stop_at(at_, "found no JSON object: found " + found() + ", expected " + expected);
  }
  std::string found() const {
    if (at_ == text_.size()) return "the end";
    if (text_[at_] == '[') return "a list";
    return in_quotes(text_.substr(at_, std::max<std::size_t>(utf8_length(text_.substr(at_)), 1)));
  }

  /// The next character that is not blank; 0 at the end.
  char peek() {
    at_ = std::min(text_.find_first_not_of(" \t\n\r", at_), text_.size());
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }

  JsonNode value(int depth) {
    if (depth > 8) stop_at(at_, "found values nested more than 8 deep, expected lists of numbers");
    JsonNode node;
    const char c = peek();
    if (c == '{') {
      read_object(node, depth);
    } else if (c == '[') {
      read_list(node, depth);
    } else if (c == '"') {
      node.kind = JsonNode::Kind::text;
      node.text = quoted();
    } else {
      read_word(node);
    }
    return node;
  }

  void read_object(JsonNode& node, int depth) {
    node.kind = JsonNode::Kind::object;
    ++at_;
    if (take('}')) return;
    do {
      if (peek() != '"') {
        const std::size_t begin = at_;
        JsonNode key;
        read_word(key);
        stop_at(begin, "found " + std::string(text_.substr(begin, at_ - begin)) + ", expected a key");
      }
      const std::size_t begin = at_;
      const std::string_view key = quoted();
      if (node.find(key) != nullptr) {
        stop_at(begin, "found the key " + in_quotes(key) + " twice, expected it once");
      }
      if (!take(':')) stop("':'");
      node.items.push_back(value(depth + 1));
      node.keys.push_back(key);
    } while (take(','));
    if (!take('}')) stop("',' or '}'");
  }

  void read_list(JsonNode& node, int depth) {
    node.kind = JsonNode::Kind::list;
    ++at_;
    if (take(']')) return;
    do {
      JsonNode next = value(depth + 1);
      if (next.kind == JsonNode::Kind::number && node.items.empty()) {
        node.numbers.push_back(next.text);
        continue;
      }
      for (const std::string_view number : node.numbers) node.items.push_back(number_node(number));
      node.numbers.clear();
      node.items.push_back(std::move(next));
    } while (take(','));
    if (!take(']')) stop("',' or ']'");
  }

  void read_word(JsonNode& node) {
    constexpr std::array<std::pair<std::string_view, JsonNode::Kind>, 6> words{{{"null", JsonNode::Kind::null},
                                                                                {"true", JsonNode::Kind::truth},
                                                                                {"false", JsonNode::Kind::truth},
                                                                                {"NaN", JsonNode::Kind::number},
                                                                                {"Infinity", JsonNode::Kind::number},
                                                                                {"-Infinity", JsonNode::Kind::number}}};
    const std::size_t begin = at_;
    for (const auto& [word, kind] : words) {
      if (!text_.substr(at_).starts_with(word)) continue;
      at_ += word.size();
      node.kind = kind;
      node.text = text_.substr(begin, word.size());
      return;
    }
    take_if('-');
    const std::size_t whole = at_;
    take_digits("a value");
    if (text_[whole] == '0' && at_ > whole + 1) at_ = whole + 1;  // no leading zeros
    if (take_if('.')) take_digits("a digit");
    if (take_if('e') || take_if('E')) {
      if (!take_if('+')) take_if('-');
      take_digits("a digit");
    }
    if (at_ < text_.size() && is_digit(text_[at_])) stop("',' or the end of the list or the object");
    node.kind = JsonNode::Kind::number;
    node.text = text_.substr(begin, at_ - begin);
  }
  bool take_if(char c) {
    const bool there = at_ < text_.size() && text_[at_] == c;
    if (there) ++at_;
    return there;
  }
  void take_digits(const std::string& expected) {
    if (at_ == text_.size() || !is_digit(text_[at_])) stop(expected);
    while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
  }

  std::string_view quoted() {
    const std::size_t begin = ++at_;
    std::string decoded;
    bool is_plain = true;
    while (at_ < text_.size() && text_[at_] != '"') {
      if (text_[at_] == '\\') {
        if (is_plain) decoded = text_.substr(begin, at_ - begin);
        is_plain = false;
        read_escape(decoded);
        continue;
      }
      const std::size_t length = utf8_length(text_.substr(at_));
      if (length == 0 || static_cast<unsigned char>(text_[at_]) < 0x20) stop("a character of a text");
      if (!is_plain) decoded += text_.substr(at_, length);
      at_ += length;
    }
    if (at_ == text_.size()) stop("'\"'");
    const std::string_view source = text_.substr(begin, at_++ - begin);
    return is_plain ? source : std::string_view(tree_.texts.emplace_back(std::move(decoded)));
  }

  void read_escape(std::string& text) {
    constexpr std::string_view names = "\"\\/bfnrt", meanings = "\"\\/\b\f\n\r\t";
    ++at_;
    if (take_if('u')) {
      std::uint32_t c = hexadecimal();
      if (c >= 0xD800 && c < 0xDC00) {
        if (!text_.substr(at_).starts_with("\\u")) stop("the second half of a character");
        at_ += 2;
        const std::uint32_t low = hexadecimal();
        if (low < 0xDC00 || low > 0xDFFF) stop("the second half of a character");
        c = 0x10000 + ((c - 0xD800) << 10U) + (low - 0xDC00);
      } else if (c >= 0xDC00 && c <= 0xDFFF) {
        stop("the first half of a character");
      }
      append_utf8(text, c);
      return;
    }
    const std::size_t which = at_ < text_.size() ? names.find(text_[at_]) : std::string_view::npos;
    if (which == std::string_view::npos) stop("an escape");
    text += meanings[which];
    ++at_;
  }

  std::uint32_t hexadecimal() {
    std::uint32_t value = 0;
    const char* const begin = text_.data() + at_;
    if (text_.size() - at_ < 4 || std::from_chars(begin, begin + 4, value, 16).ptr != begin + 4)
      stop("four hexadecimal digits");
    at_ += 4;
    return value;
  }

  static JsonNode number_node(std::string_view text) {
    JsonNode node;
    node.kind = JsonNode::Kind::number;
    node.text = text;
    return node;
  }

  std::string_view text_;
  JsonTree& tree_;
  std::size_t at_ = 0;
};

}  // namespace

const JsonNode* JsonNode::find(std::string_view key) const {
  const auto at = std::ranges::find(keys, key);
  return at == keys.end() ? nullptr : &items[static_cast<std::size_t>(at - keys.begin())];
}

JsonNode JsonNode::item(std::size_t k) const {
  if (numbers.empty()) return items[k];
  JsonNode node;
  node.kind = Kind::number;
  node.text = numbers[k];
  return node;
}

JsonTree read_json_tree(std::string_view text) {
  JsonTree tree;
  JsonReader(text, tree).read();
  return tree;
}

std::string_view name(JsonNode::Kind kind) {
  constexpr std::array<std::string_view, 6> names{"null", "a truth value", "a number", "a text", "a list", "an object"};
  return names[static_cast<std::size_t>(kind)];
}

}  // namespace slipproof
