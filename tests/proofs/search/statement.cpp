// Statements as text: each mistake is reported with its place.
#include <doctest/doctest.h>

#include <string>

#include "proofs/search/statement_mistakes.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

const std::string header = "slipproof-statement 1\ntheorem t\n";

}  // namespace

TEST_CASE("mistakes in a statement are reported with line, column, what was found and what was expected") {
  const std::string number = "a number, `(`, or a name that the lines above give to a value\n";
  const std::vector<std::pair<std::string, std::string>> table{
      {"", "s:1: the file ends before its first line, `slipproof-statement 1`\n"},
      {"slipproof-statement 1\n", "s:2: the file ends before its line `theorem NAME`\n"},
      {"slipproof-statement 2\ntheorem t\nshow false\n",
       "s:1:1: found `slipproof`, expected the first line to be `slipproof-statement 1`\n"},
      {"slipproof-statement 1\nlemma t\nshow false\n", "s:2:1: found `lemma`, expected `theorem`\n"},
      {header + "real x\n", "s:4: the file ends before its last line, `show FORMULA`\n"},
      {header + "real x\nshwo x > 0\n",
       "s:4:1: found `shwo`, expected one of real, let, define, assume, exists, show\n"
       "s:5: the file ends before its last line, `show FORMULA`\n"},
      {header + "real x x\nshow x > 0\n", "s:3:8: the name `x` is given twice\n"},
      {header + "real or\nshow 1 > 0\n", "s:3:6: `or` is a word of the language, expected another name\n"},
      {header + "real 2x\nshow 1 > 0\n",
       "s:3:6: found `2x`, expected a name: a letter, then letters, digits, `_`, `'` and `.`\n"},
      {header + "real x\nassume a: {x >= 0 or y > 1} and x + z < 3\nshow x > 0\n",
       "s:4:22: found `y`, expected " + number},
      {header + "real x\nassume a: x\nshow x > 0\n",
       "s:4:12: found the end of the line, expected a comparison: one of < <= = != >= >\n"},
      {header + "real x\nassume a x > 0\nshow x > 0\n", "s:4:10: found `x`, expected `:`\n"},
      {header + "real x\nlet y = x +\nlet z = y*y\nshow z > 0 and y >\n",
       "s:4:12: found the end of the line, expected " + number + "s:6:19: found the end of the line, expected " +
           number},
      {header + "real x\nshow (x + 1 > 0\n", "s:4:13: found `>`, expected `)`\n"},
      {header + "real x\nshow x > 0.5\n", "s:4:10: found `0.5`, expected " + number},
      {header + "real x\nshow x > 05\n", "s:4:10: found `05`, expected a number that does not begin with zero\n"},
      {header + "real x\nshow x^65 > 0\n", "s:4:8: found `65`, expected an exponent from 1 to 64\n"},
      {header + "real x\nshow x > 1/(x - x)\n", "s:4:11: division by zero\n"},
      {header + "real x\nshow (x^64)^64 > 0\n", "s:4:6: a degree exceeds 255\n"},
      {header + "real x\nshow x > 0 x\n", "s:4:12: found `x`, expected the end of the line\n"},
      {header + "real x\nshow x > 0\nshow x > 1\n", "s:5:1: found `show`, expected nothing after `show`\n"},
      {header + "exists u\nassume a: u > 0\nshow u > 0\n", "s:4:1: `assume` may not follow `exists`\n"},
      {header + "real x\n# split: x - y\nshow x > 0\n", "s:4:14: found `y`, expected " + number},
      {header + "real x\nshow x > \xC3\xA9\n", "s:4:10: found a byte of value 195, expected printable ASCII\n"},
      {header + "show " + std::string(200, '(') + "1" + std::string(200, ')') + " > 0\n",
       "s:3:106: more than 100 levels of brackets\n"}};
  for (const auto& [text, expected] : table) {
    CHECK(mistakes(text) == expected);
  }
}

TEST_CASE("what would take memory or time without bound is refused") {
  std::string doubled = header + "define d0: 1 = 0 or 1 = 0\n", chain = header + "define d0: 1 = 0\n";
  for (int i = 1; i < 200; ++i) {
    const std::string line = "define d" + std::to_string(i) + ": ", before = "d" + std::to_string(i - 1);
    doubled += line + before + " and " + before + "\n";
    chain += line + before + (i % 2 == 0 ? " and" : " or") + " 1 > 0\n";
  }
  CHECK(mistakes(doubled + "show false\n") == "s:19:13: a formula of more than 100000 comparisons\n");
  CHECK(mistakes(chain + "show false\n") == "s:104:14: a formula of more than 100 levels\n");
  const std::string power = header + "real a b c d e f g h\nshow (a + b + c + d + e + f + g + h)^40 > 0\n";
  CHECK(mistakes(power) == "s:4:6: a product has more than 200000 terms\n");
  CHECK(mistakes(header + "show (2^64)^64*(2^64)^64*(2^64)^64 > 0\n") ==
        "s:3:15: a coefficient has more than 8192 bits\n");
  std::string sum = "1";
  for (int i = 0; i < 100'000; ++i) sum += "+1";
  CHECK(mistakes(header + "show " + sum + " > 0\n").find("more than 1000 operators") != std::string::npos);
  CHECK(mistakes(header + "show " + std::string(5'000, '9') + " > 0\n").find("2500 digits") != std::string::npos);
}

TEST_CASE("no assumption may have a name that certificates need") {
  const std::string part = header + "real x\nassume a: x > 0 and x < 2\nassume ";
  CHECK(mistakes(part + "a.1: x < 1\nshow x > 0\n") == "s:5: `a.1` names a part of `a`, expected another name\n");
  CHECK(mistakes(part + "a.b: x < 1\nshow x > 0\n").empty());
  CHECK(mistakes(part + "goal: x < 1\nassume goal.2: x < 1\nshow x > 0\n") ==
        "s:5: `goal` names the negated conclusion in certificates, expected another name\n"
        "s:6: `goal.2` names the negated conclusion in certificates, expected another name\n"
        "s:6: `goal.2` names a part of `goal`, expected another name\n");
}

TEST_CASE("names may have primes and dots, and minus signs may follow each other") {
  CHECK(mistakes(header + "real x' y.1 end\nlet f.x = x' - -y.1\ndefine or': f.x > 0 or end = --end\nshow or'\n")
            .empty());
}
