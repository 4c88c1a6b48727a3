// JSON with numbers as they are written, and NaN, Infinity and -Infinity as Python writes them.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace slipproof {

/// A value. Its texts are those of the source and of the tree, which must outlive it.
struct JsonNode {
  enum class Kind : std::uint8_t { null, truth, number, text, list, object };
  Kind kind = Kind::null;
  std::string_view text;                  ///< of a number or a truth value as it is written, of a text its contents
  std::vector<JsonNode> items;            ///< of a list, or of an object with its keys
  std::vector<std::string_view> keys;     ///< of an object
  std::vector<std::string_view> numbers;  ///< of a list of numbers only, in place of the items: a tenth of the memory

  /// Of a list.
  std::size_t size() const { return items.size() + numbers.size(); }
  JsonNode item(std::size_t k) const;
  /// Of an object; null if it has no such key.
  const JsonNode* find(std::string_view key) const;
};

struct JsonTree {
  JsonNode root;
  std::deque<std::string> texts;  ///< those with escapes, decoded
};

/// Reads a text that is one object; `text` must outlive it. Throws FormatStop: for what is not JSON, for a duplicate
/// key, and for values nested more than 8 deep.
JsonTree read_json_tree(std::string_view text);

/// "found a list", "found null", for messages.
std::string_view name(JsonNode::Kind kind);

}  // namespace slipproof
