// JSON with numbers as they are written, and NaN, Infinity and -Infinity as Python writes them.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace slipproof {

/// A JSON value. Refers to texts in the source and in the tree, which must outlive it.
struct JsonNode {
  enum class Kind : std::uint8_t { null, truth, number, text, list, object };
  Kind kind = Kind::null;
  std::string_view text;               ///< a number or truth value as written, or the contents of a string
  std::vector<JsonNode> items;         ///< the elements of a list, or the values of an object
  std::vector<std::string_view> keys;  ///< keys of an object
  /// Elements of a list of numbers only, instead of `items`: takes a tenth of the memory.
  std::vector<std::string_view> numbers;

  /// The length of a list.
  std::size_t size() const { return items.size() + numbers.size(); }
  JsonNode item(std::size_t k) const;
  /// The value of a key in an object; null if the key is missing.
  const JsonNode* find(std::string_view key) const;
};

struct JsonTree {
  JsonNode root;
  std::deque<std::string> texts;  ///< those with escapes, decoded
};

/// Reads a JSON object; `text` must outlive the tree. Throws FormatStop if the text is not a JSON object, for a
/// duplicate key, and for values nested more than 8 deep.
JsonTree read_json_tree(std::string_view text);

/// "found a list", "found null", for messages.
std::string_view name(JsonNode::Kind kind);

}  // namespace slipproof
