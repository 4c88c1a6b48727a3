#include "base/input/toml.hpp"

#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

using slipproof::Diagnostic;
using slipproof::InputError;
using slipproof::Mistakes;
using slipproof::parse_toml;
using slipproof::Place;
using slipproof::TomlValue;

namespace {

TomlValue parsed(const std::string& text) {
  Mistakes mistakes("t");
  auto root = parse_toml(text, mistakes);
  mistakes.refuse_if_any();
  REQUIRE(root);
  return *root;
}

/// The one mistake of a text, as the program prints it.
std::string toml_refusal(const std::string& text) {
  Mistakes mistakes("t");
  const auto root = parse_toml(text, mistakes);
  CHECK(root.has_value() == mistakes.empty());
  try {
    mistakes.refuse_if_any();
  } catch (const InputError& error) {
    CHECK(error.diagnostics().size() == 1);
    return error.what();
  }
  return "accepted";
}

const TomlValue& at(const TomlValue& table, const char* key) {
  REQUIRE(table.find(key) != nullptr);
  return table.find(key)->value;
}

/// What stands at a place of a text.
std::string character_at(const std::string& text, Place place) {
  std::size_t offset = 0;
  for (std::size_t line = 1; line < place.line; ++line) offset = text.find('\n', offset) + 1;
  const auto continues = [&] {
    return offset < text.size() && (static_cast<unsigned char>(text[offset]) & 0xc0) == 0x80;
  };
  for (std::size_t column = 1; column < place.column; ++column) {
    ++offset;
    while (continues()) ++offset;
  }
  const std::size_t start = offset++;
  while (continues()) ++offset;
  return text.substr(start, offset - start);
}

}  // namespace

TEST_CASE("values know their kind, their digits as written, and their place") {
  const TomlValue root = parsed(
      "a = 0.10 # comment\n"
      "[t]\n"
      "  b = [1e-400, +1_000]\n"
      "  c = {d = true, e = 1979-05-27}\n"
      "x.y = 'z'\n"
      "[[u]]\n"
      "[[u]]\n"
      "v = 0xFF\n");
  CHECK(at(root, "a").kind == TomlValue::Kind::number);
  CHECK(at(root, "a").text.text() == "0.10");
  CHECK(at(root, "a").place == Place{1, 5});
  const TomlValue& t = at(root, "t");
  CHECK(t.kind == TomlValue::Kind::table);
  CHECK(t.place == Place{2, 2});
  CHECK(at(t, "b").kind == TomlValue::Kind::array);
  CHECK(at(t, "b").items.at(0).text.text() == "1e-400");
  CHECK(at(t, "b").items.at(0).place == Place{3, 8});
  CHECK(at(t, "b").items.at(1).text.text() == "+1_000");
  CHECK(at(at(t, "c"), "d").kind == TomlValue::Kind::boolean);
  CHECK(at(at(t, "c"), "d").text.text() == "true");
  CHECK(at(at(t, "c"), "e").kind == TomlValue::Kind::date);
  CHECK(at(t, "c").place == Place{4, 7});
  CHECK(at(at(t, "x"), "y").text.text() == "z");
  CHECK(at(root, "u").items.size() == 2);
  CHECK(at(root, "u").items.at(1).place.line == 7);
  CHECK(at(at(root, "u").items.at(1), "v").text.text() == "0xFF");
  CHECK(root.find("nothing") == nullptr);
}

TEST_CASE("entries of a table come in the order of the file") {
  const TomlValue root = parsed("z = 1\nm = 2\na = 3\n");
  std::string order;
  for (const auto& entry : root.entries) order += entry.key;
  CHECK(order == "zma");
  CHECK(root.entries[1].place == Place{2, 1});
}

TEST_CASE("every character of a string value knows where it stands in the file") {
  // Each value holds the letters a to f somewhere; wherever they are, the file has them at the place that is told.
  const std::vector<std::string> texts = {
      "s = \"abcdef\"",
      "s = 'abcdef'  # abcdef",
      "s = \"a\\tb\\u00e9c\\U0001F600d\\\\e\\\"f\"",
      "name = \"éé\"\ns = \"aéb€cd😀e f\"",
      "s = \"\"\"\nab\ncd\n\nef\"\"\"",
      "s = \"\"\"abc\\\n    \n  d\\t\\\n e\n  f\"\"\"",
      "s = '''\r\na\\tb\r\ncd\r\n  ef'''",
      "s = \"\"\"a\"b\"\"c\\\"\\\"\\\"def\"\"\"\"\"",
      "\xef\xbb\xbfs = \"abcdef\"",
  };
  for (std::string text : texts) {
    CAPTURE(text);
    const TomlValue root = parsed(text);
    const auto& string = at(root, "s").text;
    if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
    for (const char letter : std::string("abcdef")) {
      const std::size_t position = string.text().find(letter);
      REQUIRE(position != std::string::npos);
      CHECK(character_at(text, string.at(position)) == std::string(1, letter));
    }
  }
  const std::string quoted = "s = \"abc\"";
  CHECK(parsed(quoted).find("s")->value.text.at(3) == Place{1, 9});
  CHECK(parsed("s = \"\"").find("s")->value.text.at(0) == Place{1, 6});
}

TEST_CASE("syntax errors have a place and a reason") {
  CHECK(toml_refusal("a = 1\nb = \"x\nc = 2\n").starts_with("t:2:7: not TOML: "));
  CHECK(toml_refusal("a = 1\na = 2\n") ==
        "t:2:5: not TOML: Error while parsing key-value pair: cannot redefine existing integer 'a'");
  CHECK(toml_refusal("[a\n").starts_with("t:1:3: not TOML: "));
  CHECK(toml_refusal("a").starts_with("t:1:"));
  CHECK(toml_refusal("[!]").starts_with("t:1:2: not TOML: "));  // toml++'s own assertion fails there
}

TEST_CASE("numbers that TOML does not know as bare values are to be written in quotes") {
  for (const std::string number : {"3/4", "0x1.8p-3", ".5", "5.", "007", "1e400", "100000000000000000000"}) {
    CAPTURE(number);
    CHECK(toml_refusal("[t]\nR = " + number + "  # m\n") ==
          "t:2:5: found the bare number '" + number + "', which TOML does not allow or hold, expected it in quotes");
  }
  CHECK(toml_refusal("R = 1,5\n") == "t:1:6: found ',', expected '.' as the decimal point, and no separators");
  CHECK(toml_refusal("R = NaN\n") == "t:1:5: found NaN, expected a finite number");
  CHECK(toml_refusal("R = 1e999999999\n") == "t:1:7: found the exponent 999999999, expected one from -5000 to 5000");
  CHECK(toml_refusal("R = five\n").starts_with("t:1:6: not TOML: "));
}

TEST_CASE("hostile bytes are refused, not obeyed") {
  CHECK(toml_refusal("a = \"\xff\"") == "t:1:6: found the byte 0xff, expected UTF-8 text");
  CHECK(toml_refusal("# caf\xc3") == "t:1:6: found the byte 0xc3, expected UTF-8 text");
  CHECK(toml_refusal("a = \"\xed\xa0\x80\"") == "t:1:6: found the byte 0xed, expected UTF-8 text");
  // Letters beyond ASCII where they do not belong.
  CHECK(toml_refusal("\nR = −5") ==
        "t:2:5: not TOML: Error while parsing value: could not determine value type: found `−` (U+2212; write `-`)");
  for (const std::string text :
       {"é = 1", "a = \"x\" é", "a = \"\"\"\"\"\"\"\"é", "a = \"\\é\"", "a = 1\"é\"", "a = é", "[é]"}) {
    CAPTURE(text);
    CHECK(toml_refusal(text) != "accepted");
  }
  CHECK(toml_refusal("a = \"\"\"\\\n é\"\"\" # é\n'é' = 'é'") == "accepted");
  CHECK(toml_refusal(std::string("a\0b", 3)).starts_with("t:1:2: not TOML: "));
  CHECK(toml_refusal("a = " + std::string(100'000, '[')).find("nested") != std::string::npos);
  std::string inline_tables = "a = ";
  for (int i = 0; i < 10'000; ++i) inline_tables += "{a = ";
  CHECK(toml_refusal(inline_tables).find("nested") != std::string::npos);
  std::string key = "a";
  for (int i = 0; i < 100'000; ++i) key += ".a";
  CHECK(toml_refusal("[" + key + "]") == "t:1:33: found a key of more than 16 parts, expected a shorter one");
  CHECK(toml_refusal("\n" + key + " = 1") == "t:2:32: found a key of more than 16 parts, expected a shorter one");
  CHECK(toml_refusal("a = {" + key + " = 1}").find("16 parts") != std::string::npos);
  CHECK(toml_refusal("# " + key + "\na = '" + key + "' # " + key) == "accepted");
  CHECK(toml_refusal("a = \"\"\"x\"\" " + key + "\"\"\"") == "accepted");  // two quotes do not end it
}

TEST_CASE("tables as deep as the limits allow are read") {
  std::string text;
  const std::string key = "a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a";
  text += "[" + key + "]\n";
  std::string close;
  for (int i = 0; i < 30; ++i) {
    text += key + " = {";
    close += "}";
    if (i == 0) text += "x = 1, ";
  }
  CHECK(toml_refusal(text + close) == "accepted");
}

TEST_CASE("no mutation of a document does harm") {
  const std::string document =
      "name = \"é \\u00e9 \\\\ \"  # c\n[b.'q']\nR = 0.1\nm = \"\"\"a \\\n  b\"\"\"\nl = '''x\n'''\n[[u]]\nv = [1, {w "
      "= 2e3}]\n"
      "d = 1979-05-27T07:32:00Z\n";
  const std::string alphabet = "\"'\\\n\r\t =.,[]{}#0aeuUxn_+-:\x80\xc3\xa9\xff";
  std::mt19937_64 random(1);
  int accepted = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string text = document;
    for (std::uint64_t n = 1 + random() % 4; n > 0; --n) {
      const std::size_t position = random() % text.size();
      const char c = alphabet[random() % alphabet.size()];
      switch (random() % 4) {
        case 0:
          text[position] = c;
          break;
        case 1:
          text.insert(position, 1 + random() % 3, c);
          break;
        case 2:
          text.erase(position, 1 + random() % 5);
          break;
        default:
          text.insert(position, text.substr(random() % text.size(), random() % 20));
      }
      if (text.empty()) text = "a";
    }
    Mistakes mistakes("t");
    const auto root = parse_toml(text, mistakes);
    REQUIRE(root.has_value() == mistakes.empty());
    accepted += root.has_value() ? 1 : 0;
  }
  CHECK(accepted > 1000);  // the mutations are not all so coarse that they end at once
}

TEST_CASE("what toml_string writes reads back") {
  for (const std::string text :
       {"plain", "", "qu\"ote \\ back", "tab\t nl\n cr\r nul ", "é€😀", "'''\"\"\"", "\x7f\x01"}) {
    CHECK(parsed("s = " + slipproof::toml_string(text)).find("s")->value.text.text() == text);
  }
  const std::string nul("a\0b", 3);
  CHECK(parsed("s = " + slipproof::toml_string(nul)).find("s")->value.text.text() == nul);
  CHECK(parsed("s = " + slipproof::toml_string("a\xff"
                                               "b"))
            .find("s")
            ->value.text.text() ==
        "a\xef\xbf\xbd"
        "b");
}
