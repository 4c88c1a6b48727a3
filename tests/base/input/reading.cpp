// Tables, suggestions, diagnostics and files.
#include <doctest/doctest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "base/input/near_match.hpp"
#include "base/input/table_reader.hpp"
#include "base/input/text_file.hpp"

using slipproof::InputError;
using slipproof::Mistakes;
using slipproof::Place;
using slipproof::Rational;
using slipproof::TableReader;

namespace {

constexpr std::array<std::string_view, 6> keys{"number", "text", "flag", "list", "claim", "part"};

struct Document {
  explicit Document(const std::string& text) : root(*slipproof::parse_toml(text, mistakes)) {}
  std::string refusal() const {
    try {
      mistakes.refuse_if_any();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  Mistakes mistakes{"t"};
  slipproof::TomlValue root;
};

std::string read_refusal(const std::filesystem::path& path, std::size_t limit = slipproof::max_text_file_size) {
  try {
    slipproof::read_text_file(path, limit);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a table gives its values by key and kind") {
  Document document(
      "number = 0.1\ntext = 'abc'\nflag = true\nlist = ['x', 'y']\n[part]\n[[claim]]\nid = 1\n[[claim]]\nid = 2\n");
  const TableReader table(document.root, "", keys, document.mistakes);
  CHECK(table.number("number") == Rational(1, 10));
  CHECK(table.string("text")->text() == "abc");
  CHECK(table.boolean("flag") == true);
}

TEST_CASE("what a table should not hold is reported at its place, and the rest is read all the same") {
  Document document("number = true\ntext = 1\nflag = 'x'\nlist = ['x', 2]\nclam = 1\npart = 3\nzzz = 1\n");
  const TableReader table(document.root, "", keys, document.mistakes);
  CHECK(!table.number("number"));
  CHECK(table.string("text") == nullptr);
  CHECK(!table.boolean("flag"));
  CHECK(table.strings("list").size() == 1);
  CHECK(table.table("part") == nullptr);
  CHECK(table.tables("claim").empty());
  CHECK(!table.require("claim", "the claims"));
  CHECK(document.refusal() ==
        "t:1:1: missing claim, expected the claims\n"
        "t:1:10: number: found a boolean, expected a number\n"
        "t:2:8: text: found a number, expected a string\n"
        "t:3:8: flag: found a string, expected a boolean\n"
        "t:4:14: list: found a number, expected a string\n"
        "t:5:1: unknown key 'clam', did you mean 'claim'?\n"
        "t:6:8: part: found a number, expected a table\n"
        "t:7:1: unknown key 'zzz', expected one of number, text, flag, list, claim, part");
}

TEST_CASE("arrays of tables and of strings, nested tables and their names") {
  Document document("list = ['x', 'y']\n[part]\nnumber = 1\ntxt = 2\n[[claim]]\ntext = 'a'\n[[claim]]\ntext = 'b'\n");
  const TableReader table(document.root, "", keys, document.mistakes);
  CHECK(table.strings("list").at(1)->text() == "y");
  REQUIRE(table.tables("claim").size() == 2);
  CHECK(TableReader(*table.tables("claim")[1], "claim", keys, document.mistakes).string("text")->text() == "b");
  CHECK(document.refusal().empty());
  const TableReader part(*table.table("part"), "[part]", keys, document.mistakes);
  CHECK(part.has("number"));
  CHECK(!part.has("text"));
  part.require("text", "words");
  CHECK(document.refusal() ==
        "t:2:2: missing text in [part], expected words\n"
        "t:4:1: unknown key 'txt' in [part], did you mean 'text'?");
}

TEST_CASE("a malformed number is reported at the character, quotes, escapes and all") {
  Document document("text = \"\\u0031x\"\nnumber = \"1/0\"\nlist = inf\nflag = 0o17\npart = 1_0.5\n");
  const TableReader table(document.root, "", keys, document.mistakes);
  for (const auto key : {"text", "number", "list", "flag"}) CHECK(!table.number(key));
  CHECK(table.number("part") == Rational(21, 2));
  CHECK(document.refusal() ==
        "t:1:15: text: found 'x', expected the end of the number\n"
        "t:2:13: number: found a zero denominator, expected a denominator other than 0\n"
        "t:3:8: list: found infinity, expected a finite number\n"
        "t:4:9: flag: found 'o', expected the end of the number");
}

TEST_CASE("near matches are near") {
  constexpr std::array<std::string_view, 8> names{"h", "h0", "b2", "b3", "road", "bicycle", "M", "mu"};
  const auto match = [&names](std::string_view word) {
    return std::string(slipproof::near_match(word, names).value_or("none"));
  };
  CHECK(match("bycicle") == "bicycle");
  CHECK(match("Bicycle") == "bicycle");
  CHECK(match("raod") == "road");
  CHECK(match("roads") == "road");
  CHECK(match("h1") == "h");
  CHECK(match("H") == "h");
  CHECK(match("m") == "M");
  CHECK(match("x") == "none");
  CHECK(match("b4") == "b2");
  CHECK(match("velocity") == "none");
  CHECK(match("") == "none");
  CHECK(match(std::string(1'000'000, 'h')) == "none");
}

TEST_CASE("messages show what was found without its control characters, and not all of it") {
  CHECK(slipproof::in_quotes("a\x1b[31m\n") == "'a\\x1b[31m\\x0a'");
  CHECK(slipproof::in_quotes(std::string(100, 'x')) == "'" + std::string(60, 'x') + "...'");
  std::string accents;
  for (int i = 0; i < 100; ++i) accents += "é";
  CHECK(slipproof::in_quotes("x" + accents) == "'x" + accents.substr(0, 60) + "...'");
}

TEST_CASE("files that are none") {
  const std::filesystem::path directory =
      std::filesystem::temp_directory_path() / ("slipproof-input-" + std::to_string(::getpid()));
  std::filesystem::create_directory(directory);
  const auto file = directory / "file";
  std::ofstream(file) << "0123456789";
  CHECK(slipproof::read_text_file(file) == "0123456789");
  CHECK(slipproof::read_text_file(file, 10) == "0123456789");
  CHECK(read_refusal(file, 9) == file.string() + ": longer than 9 bytes, expected a shorter file");
  CHECK(read_refusal("/dev/zero") == "/dev/zero: longer than 1048576 bytes, expected a shorter file");
  CHECK(read_refusal(directory) == directory.string() + ": found a directory, expected a file");
  CHECK(read_refusal(directory / "none") ==
        (directory / "none").string() + ": cannot be opened: No such file or directory");
  CHECK(read_refusal("") == "cannot be opened: No such file or directory");
  std::filesystem::remove_all(directory);
}
