// A TOML document as a tree of values that know their places. Numbers stay the digits that were written: nothing here
// passes through binary64.
//
//   const std::string text = read_text_file(path);
//   Mistakes mistakes(path.string());
//   if (const auto root = parse_toml(text, mistakes)) { ... TableReader reads it (table_reader.hpp) ... }
//   mistakes.refuse_if_any();
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/input/diagnostic.hpp"

namespace slipproof {

/// A text from a file that knows the place of each of its characters there: accounts for escapes, line-ending
/// backslashes and line breaks inside a TOML string.
class PlacedText {
 public:
  PlacedText() = default;
  PlacedText(std::string text, Place start) : text_(std::move(text)), steps_{{0, start}} {}

  const std::string& text() const { return text_; }
  /// The place in the file of the character at byte `position` of text(); for the end of text(), the place after it.
  Place at(std::size_t position) const;

  /// From byte `position` of text() on, characters stand at `place` and to the right of it. Positions must not
  /// decrease.
  void continue_at(std::size_t position, Place place) { steps_.push_back({position, place}); }

 private:
  struct Step {
    std::size_t position;
    Place place;
  };
  std::string text_;
  std::vector<Step> steps_;
};

struct TomlEntry;

/// One value. Which members are used depends on its kind.
struct TomlValue {
  enum class Kind { string, number, boolean, date, array, table };
  Kind kind = Kind::table;
  Place place;                     ///< place of its first character; for a [table], of its name in the header
  PlacedText text;                 ///< string: its value, placed inside the quotes. Number, boolean, date: as written
  std::vector<TomlValue> items;    ///< array
  std::vector<TomlEntry> entries;  ///< table, in the order of the file

  /// The entry of a table; null if it has none.
  const TomlEntry* find(std::string_view key) const;
};

struct TomlEntry {
  std::string key;
  Place place;  ///< place of the key
  TomlValue value;
};

/// "a string", "a number", ...
std::string_view kind_name(TomlValue::Kind kind);

/// The root table of a TOML 1.0 document. Reports the first syntax error to `mistakes`, and then returns nothing. Safe
/// for any bytes. Beyond TOML's own rules, refuses keys of more than 16 parts and values nested more than 32 deep.
std::optional<TomlValue> parse_toml(std::string_view text, Mistakes& mistakes);

/// `text` as a basic string of TOML, quotes included; bytes that are not UTF-8 become U+FFFD.
std::string toml_string(std::string_view text);

}  // namespace slipproof
