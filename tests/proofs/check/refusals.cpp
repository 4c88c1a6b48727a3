// Statements that are malformed, and texts that would take memory without bound, are refused with rule and line.
#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "proofs/check/examples.hpp"

using namespace slipproof::check;

TEST_CASE("malformed statements are refused with rule and line") {
  std::string sum = "1";
  for (int i = 0; i <= 1'000; ++i) sum += "+1";
  const std::vector<std::pair<std::string, std::string>> table = {
      {"slipproof-statement 1\ntheorem t\nshow " + sum + " > 0\n", "show: an expression has too many operators"},
      {"", "header: the file ends too early"},
      {"slipproof-statement 2\n", "header: expected 'slipproof-statement 1'"},
      {"slipproof-statement 1\nshow false\n", "header: expected 'theorem'"},
      {"slipproof-statement 1\ntheorem t\nreal x\n", "real: the file ends too early"},
      {"slipproof-statement 1\ntheorem t\nreal x x\nshow false\n", "real: the name is given twice"},
      {"slipproof-statement 1\ntheorem t\nreal x\nlet x = 1\nshow false\n", "let: the name is given twice"},
      {"slipproof-statement 1\ntheorem t\nreal\nshow false\n", "real: expected a name"},
      {"slipproof-statement 1\ntheorem t\nexists\nshow false\n", "exists: expected a name"},
      {"slipproof-statement 1\ntheorem t\nassume goal: 1 > 0\nshow false\n", "show: an assumption is called `goal`"},
      {"slipproof-statement 1\ntheorem t\nassume goal.2: 1 > 0\nshow false\n",
       "show: an assumption has the name of a part of `goal`"},
      {"slipproof-statement 1\ntheorem t\nassume a.1.2: 1 > 0\nassume a: 1 > 0\nshow false\n",
       "show: an assumption has the name of a part of `a`"},
      {"slipproof-statement 1\ntheorem t\nreal or\nshow false\n", "real: expected a name, found a reserved word"},
      {"slipproof-statement 1\ntheorem t\nassume a: 1 > 0\nassume a: 2 > 0\nshow false\n",
       "assume: the name is given twice"},
      {"slipproof-statement 1\ntheorem t\nassume a: y > 0\nshow false\n", "assume: expected a number or a known name"},
      {"slipproof-statement 1\ntheorem t\nreal x\nassume a: x\nshow false\n", "assume: expected a comparison"},
      {"slipproof-statement 1\ntheorem t\nreal x\nassume a: x > 1/0\nshow false\n", "assume: division by zero"},
      {"slipproof-statement 1\ntheorem t\nreal x\nassume a: x > 0 x\nshow false\n",
       "assume: expected the end of the line"},
      {"slipproof-statement 1\ntheorem t\nexists u\nassume a: u > 0\nshow false\n", "assume: unknown directive"},
      {"slipproof-statement 1\ntheorem t\nexists u\nexists v\nshow false\n", "exists: unknown directive"},
      {"slipproof-statement 1\ntheorem t\nexists u\nreal x\nshow false\n", "real: unknown directive"},
      {"slipproof-statement 1\ntheorem t\nexists u\nlet u = 1\nshow false\n", "let: the name is given twice"},
      {"slipproof-statement 1\ntheorem t\nshow false\nshow false\n", "show: nothing may follow `show`"},
      {"slipproof-statement 1\ntheorem t\nreal x\nshow x^65 > 0\n", "show: an exponent is out of range"},
      {"slipproof-statement 1\ntheorem t\nreal x\nshow x^0 > 0\n", "show: an exponent is out of range"},
      {"slipproof-statement 1\ntheorem t\nreal x\nshow ((x^64)^64) > 0\n", "show: a degree is too large"},
      {"slipproof-statement 1\ntheorem t\nshow (2^64)^64*(2^64)^64*(2^64)^64 > 0\n",
       "show: a coefficient is too large"},
      {"slipproof-statement 1\ntheorem t\nshow " + std::string(200, '(') + "1" + std::string(200, ')') + " > 0\n",
       "nested too deeply"},
      {"slipproof-statement 1\ntheorem t\nshow " + std::string(100'000, '{') + "\n", "nested too deeply"},
      {"slipproof-statement 1\ntheorem t\nshow " + std::string(5'000, '9') + " > 0\n", "a coefficient is too large"},
      {"slipproof-statement 1\ntheorem t\nreal " + std::string(200, 'x') + "\nshow false\n", "expected a name"},
      {"slipproof-statement 1\ntheorem t\nreal a b c d e f g h\nshow (a+b+c+d+e+f+g+h)^40 > 0\n",
       "a product has too many terms"},
      {"slipproof-statement 1\ntheorem t\n#" + std::string(2 << 20, 'x') + "\nshow false\n",
       "the statement is too long"}};
  for (const auto& [text, expected] : table) {
    const std::string found = verdict(text, "");
    const std::string beginning = text.substr(0, 200);  // clang 14 cannot capture structured bindings
    INFO("'", beginning, "' gave '", found, "'");
    CHECK(found.find(expected) != std::string::npos);
  }
}

TEST_CASE("what is not printable ASCII is refused with line and column, in comments as well") {
  const std::vector<std::string> bytes{"\t",           "\r",           "\x1B[2K",      std::string(1, '\0'),
                                       "\x7F",         "\v",           "\xC2\x85",     "\xC3\xA9",
                                       "\xE2\x80\xAE", "\xE2\x80\x8B", "\xEF\xBB\xBF", "\xFF"};
  const std::string statement = "slipproof-statement 1\ntheorem t\nreal x\nassume a: x > 0\nshow x > 0\n";
  const std::string certificate = header(statement) + "contradiction\nterm 1 a\nterm 1 goal\nqed\n";
  REQUIRE(verdict(statement, certificate) == "");
  for (const std::string& byte : bytes) {
    const std::string refused = " text: a byte of value " + std::to_string(static_cast<unsigned char>(byte.front())) +
                                ", expected printable ASCII";
    CAPTURE(refused);
    CHECK(verdict(byte + statement, certificate) == "S:1:1:" + refused);
    CHECK(verdict(replaced(statement, "m t", "m t" + byte), certificate) == "S:2:10:" + refused);
    CHECK(verdict(replaced(statement, "real", "# " + byte + "\nreal"), certificate) == "S:3:3:" + refused);
    CHECK(verdict(replaced(statement, "x > 0\nshow", "x > 0" + byte + "\nshow"), certificate) == "S:4:16:" + refused);
    CHECK(verdict(statement + byte, certificate) == "S:6:1:" + refused);
    CHECK(verdict(statement, replaced(certificate, " a\n", " a" + byte + "\n")) == "C:4:9:" + refused);
    CHECK(verdict(statement, replaced(certificate, "term", "  # a comment " + byte + "\nterm")) == "C:4:15:" + refused);
    CHECK(verdict(statement, certificate + "#" + byte) == "C:7:2:" + refused);
  }
}

TEST_CASE("the name of a theorem is a letter or digit, then letters, digits, _ ' . and -") {
  const auto found = [](const std::string& line) {
    return verdict("slipproof-statement 1\n" + line + "\nshow false\n", "slipproof-certificate 1\nx\n");
  };
  const std::string longest(100, 'n'), refused = "S:2: header: expected 'theorem' and a name";
  for (const std::string& name : {std::string("A5.2-b_c'd.1"), std::string("3.1"), longest}) {
    CHECK(found("theorem " + name).starts_with("C:2: header: expected 'theorem " + name + " "));
  }
  for (const char* line :
       {"theorem", "theorem ", "theorem  t", " theorem t", "theorem t ", "theorem t u", "theorem .t", "theorem -t",
        "theorem _t", "theorem 't", "theorem t/u", "theorem t:", "theorem t#", "Theorem t"}) {
    CAPTURE(line);
    CHECK(found(line) == refused);
  }
  CHECK(found("theorem " + longest + "n") == refused);
}

TEST_CASE("what would take memory without bound is refused") {
  const std::string start = "slipproof-statement 1\ntheorem t\n";
  std::string variables = start + "real";
  for (int i = 0; i < 65; ++i) variables += " x" + std::to_string(i);
  CHECK(verdict(variables + "\nshow false\n", "").find("too many variables") != std::string::npos);

  std::string deep = header(kSplitStatement);
  for (int i = 0; i < 1'100; ++i) deep += "split n" + std::to_string(i) + ": x\nbranch negative\n";
  CHECK(verdict(kSplitStatement, deep).find("nested too deeply") != std::string::npos);

  std::string formulas = start + "define d0: 1 = 0 or 1 = 0\n";  // each doubles the one before
  for (int i = 1; i < 40; ++i) {
    const std::string before = "d" + std::to_string(i - 1);
    formulas += "define d" + std::to_string(i) + ": " + before + " and " + before + "\n";
  }
  CHECK(verdict(formulas + "show false\n", "").find("a formula has too many comparisons") != std::string::npos);

  std::string chain = start + "define d0: 1 = 0\n";  // each one level deeper than the one before
  for (int i = 1; i < 200; ++i) {
    chain +=
        "define d" + std::to_string(i) + ": 1 = 0 " + (i % 2 == 0 ? "and d" : "or d") + std::to_string(i - 1) + "\n";
  }
  CHECK(verdict(chain + "show false\n", "").find("a formula is nested too deeply") != std::string::npos);

  std::string sums = start + "real a b c d e f g h\nlet s = (a + b + c + d + e + f + g + h)^5\n";  // 792 terms
  for (int i = 0; i < 1'500; ++i) sums += "let s" + std::to_string(i) + " = s\n";
  CHECK(verdict(sums + "show false\n", "").find("too many polynomials and terms") != std::string::npos);
}

// All work counts alike, so that reading, the quickest, can stand here for most of it.
TEST_CASE("a check ends where it has cost too much") {
  const std::string statement =
      "slipproof-statement 1\ntheorem t\nreal a b c d e\nassume h: (a + b + c + d + e)^6 > 0\nshow false\n";
  std::string proof = "contradiction\n", idle;
  for (int i = 0; i < 30; ++i) proof += "term 1 h h\n";
  for (int i = 0; i < 49; ++i) idle.append("#").append(1'000'000, 'x').append("\n");
  const auto found = [&](const std::string& before) {
    return verdict(statement, header(statement) + before + proof + "qed\n");
  };
  CHECK(found("").ends_with("contradiction: the lines do not add up to zero"));
  CHECK(found(idle).ends_with("contradiction: checking takes too much work"));
  CHECK(found("").ends_with("contradiction: the lines do not add up to zero"));  // what was before does not count
  CHECK(found(idle + idle).ends_with("header: checking takes too much work"));
}
