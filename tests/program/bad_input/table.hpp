// The tables of malformed inputs beside this file: what the program is given, what it must say, and its exit code.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/input/table_reader.hpp"
#include "base/input/text_file.hpp"
#include "base/number/parse.hpp"

namespace slipproof::test {

struct BadInput {
  std::string what;               ///< the mistake, in words
  std::string text;               ///< the file's bytes
  std::vector<std::string> says;  ///< the messages, without the name of the file: "line:column: message"
  int exit = 0;                   ///< the program's exit code
};

/// `text` with each second of `changes` in the place of the one before it, which must stand there exactly once.
inline std::string changed(std::string text, const std::vector<const PlacedText*>& changes,
                           const std::string& filling) {
  for (std::size_t i = 0; i + 1 < changes.size(); i += 2) {
    const std::string& old = changes[i]->text();
    std::string replacement = changes[i + 1]->text();
    const std::size_t gap = replacement.find('~');
    if (gap != std::string::npos && !filling.empty()) replacement.replace(gap, 1, filling);
    const std::size_t place = text.find(old);
    if (place == std::string::npos || text.find(old, place + 1) != std::string::npos) {
      throw std::runtime_error("not there exactly once: " + old);
    }
    text.replace(place, old.size(), replacement);
  }
  return text;
}

inline std::string bytes(const std::string& hex) {
  std::string result;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 3) {
    result += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  }
  return result;
}

/// The rows of a table. Throws InputError for a malformed table.
inline std::vector<BadInput> read_bad_inputs(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 3> root_keys{"exit", "good", "case"};
  constexpr std::array<std::string_view, 7> case_keys{"what", "change", "unit", "repeat", "text", "hex", "says"};
  Mistakes mistakes(path.string());
  const auto document = parse_toml(read_text_file(path), mistakes);
  std::vector<BadInput> rows;
  if (document) {
    const TableReader root(*document, "", root_keys, mistakes);
    const auto exit = root.number("exit");
    const PlacedText* good = root.string("good");
    for (const TomlValue* table : root.tables("case")) {
      const TableReader row(*table, "[[case]]", case_keys, mistakes);
      BadInput input;
      if (row.require("what", "the mistake in words")) input.what = row.string("what")->text();
      if (exit) input.exit = static_cast<int>(numerator(*exit).to_long());
      if (row.has("text")) {
        input.text = row.string("text")->text();
      } else if (row.has("hex")) {
        input.text = bytes(row.string("hex")->text());
      } else if (row.require("change", "text, hex or change") && good != nullptr) {
        std::string filling;
        if (const auto repeat = row.number("repeat")) {
          for (long n = numerator(*repeat).to_long(); n > 0; --n) filling += row.string("unit")->text();
        }
        input.text = changed(good->text(), row.strings("change"), filling);
      }
      for (const PlacedText* message : row.strings("says")) input.says.push_back(message->text());
      rows.push_back(std::move(input));
    }
  }
  mistakes.refuse_if_any();
  return rows;
}

/// What a reader says of a bad input, as the table has it; "accepted" if it takes it.
template <class Reader>
std::vector<std::string> said(const BadInput& input, Reader&& read) {
  try {
    read(input.text);
  } catch (const InputError& error) {
    std::vector<std::string> messages;
    for (const Diagnostic& d : error.diagnostics()) {
      messages.push_back(std::to_string(d.line) + ":" + std::to_string(d.column) + ": " + d.message);
    }
    return messages;
  }
  return {"accepted"};
}

/// Every row says what the table has, ends with this exit code, and is not there twice.
template <class Reader>
void check_bad_inputs(const std::filesystem::path& path, std::size_t at_least, Reader&& read, int exit = 3) {
  const auto rows = read_bad_inputs(path);
  CHECK(rows.size() >= at_least);
  std::set<std::string> names;
  for (const BadInput& row : rows) {
    CAPTURE(row.what);
    CHECK(names.insert(row.what).second);
    CHECK(row.exit == exit);
    const auto messages = said(row, read);
    for (std::size_t i = 0; i < std::max(messages.size(), row.says.size()); ++i) {
      const std::string expected = i < row.says.size() ? row.says[i] : "nothing more";
      const std::string found = i < messages.size() ? messages[i] : "nothing more";
      CHECK(found == expected);
    }
  }
}

/// The text of the table in which the mistakes are made.
inline std::string good_input(const std::filesystem::path& path) {
  Mistakes mistakes(path.string());
  const auto table = parse_toml(read_text_file(path), mistakes);
  REQUIRE(table);
  return table->find("good")->value.text.text();
}

}  // namespace slipproof::test
