// Reads one table of a TOML document: adds unknown, missing and malformed keys and wrong types to the list of mistakes,
// and continues.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/input/toml.hpp"
#include "base/number/rational.hpp"

namespace slipproof {

/// The number in a value: a string in one of the forms of parse_rational, or a bare TOML number, taken by its digits as
/// written. Reports anything else at its place, after `name`.
std::optional<Rational> read_number(const TomlValue& value, std::string_view name, Mistakes& mistakes);

/// Reads a table. Getters return nothing for an absent key, and for a value that they have reported as wrong; `has`
/// distinguishes the two. The table and the mistakes must outlive the reader.
class TableReader {
 public:
  /// Reports every key that is not among `keys`, with a suggestion. `name` is the name of the table in messages, empty
  /// for the root.
  TableReader(const TomlValue& table, std::string name, std::span<const std::string_view> keys, Mistakes& mistakes);

  bool has(std::string_view key) const { return table_.find(key) != nullptr; }
  /// False, and "missing KEY, expected EXPECTED" is reported at the table, if the key is absent.
  bool require(std::string_view key, std::string_view expected) const;

  /// The value, of any kind; null if absent.
  const TomlValue* value(std::string_view key) const;
  std::optional<Rational> number(std::string_view key) const;
  const PlacedText* string(std::string_view key) const;
  std::optional<bool> boolean(std::string_view key) const;
  const TomlValue* table(std::string_view key) const;
  /// The items of an array of strings; of an array of tables, such as [[claim]]. Empty if absent.
  std::vector<const PlacedText*> strings(std::string_view key) const;
  std::vector<const TomlValue*> tables(std::string_view key) const;

  /// The place of a key's value; of the table itself if the key is absent.
  Place place(std::string_view key) const;
  /// Reports "KEY: MESSAGE" at the key's value.
  void refuse(std::string_view key, const std::string& message) const;

 private:
  const TomlValue* of_kind(std::string_view key, TomlValue::Kind kind) const;
  std::vector<const TomlValue*> items(std::string_view key, TomlValue::Kind kind) const;

  const TomlValue& table_;
  std::string name_;
  Mistakes& mistakes_;
};

}  // namespace slipproof
