// A JSON object with numbers in lists, as problems and answers are written.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace slipproof {

/// One value of it, with its path ("W.entries[2][1]", counted from 1) made where a message needs it.
struct JsonNode {
  enum class Kind { number, text, list, object, other };  ///< other: null and truth values
  Kind kind = Kind::other;
  double number = 0;            ///< the nearest binary64; NaN and infinities as Python's json writes them
  std::string text;             ///< of a text, as it is
  std::vector<JsonNode> items;  ///< of a list, or of an object with its keys
  std::vector<std::string> keys;
  std::vector<double> numbers;  ///< for a list of numbers only, in place of the items: a tenth of the memory

  /// Of a list.
  std::size_t size() const { return items.size() + numbers.size(); }
  JsonNode item(std::size_t k) const;

  /// Of an object; null if it has no such key.
  const JsonNode* find(std::string_view key) const;
};

/// Reads a text that is one object. Throws InputError: with line and column if it is not JSON; for a duplicate key, and
/// for values nested more than 8 deep.
JsonNode read_json_tree(std::string_view text, const std::string& file);

/// Reads numbers out of a tree and throws InputError with the path where there are none.
class JsonNumbers {
 public:
  explicit JsonNumbers(std::string file) : file_(std::move(file)) {}

  /// A number, or a text with one in any form that scenes have: each means the nearest binary64. "NaN", "Infinity" and
  /// the like are numbers, too, if `any` allows them.
  double number(const JsonNode& node, const std::string& where, bool any = false) const;
  std::vector<double> list(const JsonNode& node, const std::string& where, bool any = false) const;
  /// A number that counts something, up to 2^53.
  std::size_t count(const JsonNode& node, const std::string& where) const;

  [[noreturn]] void refuse(const std::string& where, const std::string& message) const;

  /// How many fractions and hexadecimal numbers were read that are no binary64.
  std::size_t rounded() const { return rounded_; }

 private:
  std::string file_;
  mutable std::size_t rounded_ = 0;
};

}  // namespace slipproof
