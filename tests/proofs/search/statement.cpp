// Statements as text: each mistake is reported with its place, and the prover takes for a statement what the checker
// takes for one.
#include "proofs/statement/statement.hpp"

#include <doctest/doctest.h>

#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "proofs/check/theorem.hpp"
#include "proofs/search/prove_files.hpp"
#include "support/how_many.hpp"
#include "support/papers/shipped.hpp"
#include "support/run_program.hpp"

using namespace slipproof;

namespace {

/// The mistakes, a line each.
std::string mistakes(const std::string& text) {
  try {
    prove::Statement("s", text);
  } catch (const InputError& error) {
    std::string all;
    for (const Diagnostic& mistake : error.diagnostics()) all += to_string(mistake) + '\n';
    return all;
  }
  return "";
}

bool checker_reads(const std::string& text) {
  check::FormulaReader reader(text);
  try {
    check::Statement statement(reader);
    return true;
  } catch (const check::Rejection&) {
    return false;
  }
}

const std::string header = "slipproof-statement 1\ntheorem t\n";

using Words = std::vector<std::vector<std::string>>;  ///< of each line

std::string joined(const Words& lines) {
  std::string text;
  for (const auto& line : lines) {
    for (const std::string& word : line) text += word;
    text += '\n';
  }
  return text;
}

/// The lines that count, cut wherever letters and digits meet anything else; joined they are the text again.
Words cut(const std::string& text) {
  const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  Words lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::vector<std::string>& words = lines.emplace_back();
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (i == 0 || !is_word(line[i]) || !is_word(line[i - 1])) words.emplace_back();
      words.back() += line[i];
    }
  }
  return lines;
}

/// One change of a word or a line.
void change(Words& lines, std::mt19937_64& random) {
  const auto any = [&](std::size_t size) { return static_cast<std::size_t>(random() % size); };
  auto& line = lines[any(lines.size())];
  const auto& other = lines[any(lines.size())];
  const auto place = [&](auto& list) { return list.begin() + static_cast<std::ptrdiff_t>(any(list.size())); };
  if (line.empty() || other.empty()) return;
  static const std::vector<std::string> signs{"^", "{", "}",  "(",   ")", "<", "=", "-", "/",      "or", "and", "false",
                                              "0", "7", "x'", "y.1", " ", "!", "#", ":", "exists", "\t", "\xE9"};
  switch (any(8)) {
    case 0:
      line.erase(place(line));
      break;
    case 1:
      line.insert(place(line), other[any(other.size())]);
      break;
    case 2:
      line[any(line.size())] = other[any(other.size())];
      break;
    case 3:
      line[any(line.size())] = signs[any(signs.size())];
      break;
    case 4:
      line.insert(place(line), signs[any(signs.size())]);
      break;
    case 5:
      std::swap(line[any(line.size())], line[any(line.size())]);
      break;
    case 6:
      lines.erase(place(lines));
      break;
    default:
      std::swap(lines[any(lines.size())], lines[any(lines.size())]);
  }
}

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

TEST_CASE("the prover and the checker read the same texts, and refuse the same") {
  const auto chain = [](int terms) {
    std::string text = "x";
    for (int i = 1; i < terms; ++i) text += i % 2 == 0 ? "*x/x" : "+x";
    return text;
  };
  const auto name = [](std::size_t size) { return std::string(size, 'n'); };
  std::string doubled = "define d0: 1 = 0 or 1 = 0\n";  // 2^16 comparisons, and twice as many
  for (int i = 1; i < 16; ++i) {
    const std::string before = "d" + std::to_string(i - 1);
    doubled += "define d" + std::to_string(i) + ": " + before + " and " + before + "\n";
  }
  std::string assumptions;  // to compare each with each would take minutes
  for (int i = 0; i < 10'000; ++i) assumptions += "assume a" + std::to_string(i) + ".1: x > 0\n";
  const std::string show = "show x > 0\n", real = "real x\n", all = real + show;
  const std::string first = "slipproof-statement 1\n", start = first + "theorem t\n";
  const std::vector<std::string> good{
      start + all,
      "# a comment\n\n  \n" + start + "   # another\n" + all + "# the end",
      start + real + "show x > 0",
      start + "  real   x  \nshow  x>0  \n",
      start + "show 0 = 0\n",
      start + "show false\n",
      start + real + "assume f: false\n" + show,
      first + "theorem A5.2-b_c'd.1\n" + all,
      first + "theorem 3.1\n" + all,
      first + "theorem " + name(100) + "\n" + all,
      start + "real " + name(100) + "\nshow 1 > 0\n",
      start + "real real show let\nlet theorem = show + let\nassume exists: real > theorem\nshow let > 0\n",
      start + real + "real y\nlet z = x\nreal w\nassume a: w > z\nreal v\nexists u\nlet t = u\nshow t = v\n",
      start + real + "define d: x > 0\nassume d': d or {d and d}\nshow d\n",
      start + real + "assume a.b: x > 0\nassume a.1b: x > 0\nassume goal.x: x > 0\nassume a.x.1: x > 0\n" + show,
      start + real + "let a = x\nassume a.1: x > 0\n" + show,
      start + real + "show -x^2 < 0 <= x != 1 >= - - -x\n",
      start + real + "show 6/2/x < 1/(1/x) or (x)/1 = x/(x/(x+1))\n",
      start + real + "exists u\nshow 1/u > x\n",
      start + real + "show x^64*x^64*x^64*x^63 > 0\n",
      start + real + "show " + std::string(2'466, '9') + "*x > 0\n",
      start + real + "show " + chain(667) + " > " + chain(667) + "\n",
      start + real + "show " + std::string(100, '(') + "x" + std::string(100, ')') + " > 0\n",
      start + real + "show " + std::string(100'000, '-') + "x > 0\n",
      start + doubled + "show d15\n",
      start + real + assumptions + show,
      start + "#" + std::string(1'000'000, '=') + "\nshow false\n",
  };
  const std::vector<std::string> bad{
      "",
      "\n",
      first,
      start,
      start + real,
      " " + start + all,
      "slipproof-statement 1 \ntheorem t\n" + all,
      "slipproof-statement  1\ntheorem t\n" + all,
      "slipproof-statement 1\r\ntheorem t\r\nshow false\r\n",
      "\xEF\xBB\xBF" + start + all,
      first + "theorem\n" + all,
      first + "theorem \n" + all,
      first + "theorem  t\n" + all,
      first + " theorem t\n" + all,
      first + "theorem t \n" + all,
      first + "theorem t u\n" + all,
      first + "theorem t # u\n" + all,
      first + "theorem -t\n" + all,
      first + "theorem .t\n" + all,
      first + "theorem _t\n" + all,
      first + "theorem t/u\n" + all,
      first + "theorem t\x1B[31m\n" + all,
      first + "theorem \xD0\x90\n" + all,
      first + "theorem " + name(101) + "\n" + all,
      start + "real\n" + all,
      start + all + "exists\n",
      start + real + "exists\n" + show,
      start + "real x x\n" + show,
      start + "real x\nreal x\n" + show,
      start + "real and\nshow 1 > 0\n",
      start + "real or\nshow 1 > 0\n",
      start + "real false\nshow 1 > 0\n",
      start + real + "let and = x\n" + show,
      start + real + "define or: x > 0\n" + show,
      start + real + "assume false: x > 0\n" + show,
      start + real + "assume x: x > 0\n" + show,
      start + real + "assume goal: x > 0\n" + show,
      start + real + "assume goal.1: x > 0\n" + show,
      start + real + "assume a.1: x > 0\nassume a: x > 0\n" + show,
      start + real + "assume a.1.2: x > 0\nassume a: x > 0\n" + show,
      start + real + "assume a.: x > 0\nassume a: x > 0\n" + show,
      start + "real _x\nshow 1 > 0\n",
      start + "real 2x\nshow 1 > 0\n",
      start + "real x-y\nshow 1 > 0\n",
      start + "real x, y\nshow 1 > 0\n",
      start + "real " + name(101) + "\nshow 1 > 0\n",
      start + "real \xD1\x85\nshow 1 > 0\n",
      start + "real\tx\n" + show,
      start + "real\xC2\xA0x\n" + show,
      start + real + "# comment\r" + show,
      start + real + "# \xE2\x80\xAE\n" + show,
      start + real + "# \xC3\xA9\n" + show,
      start + real + "# \x1B[2K\n" + show,
      start + real + "#" + std::string(1, '\0') + "\n" + show,
      start + real + "# \x7F\n" + show,
      start + real + "# \xC2\x85\n" + show,
      start + real + "\v\n" + show,
      start + real + "show x > 0\f\n",
      start + real + "show x > 0.5\n",
      start + real + "show x > 05\n",
      start + real + "show x > 1e3\n",
      start + real + "show x > +1\n",
      start + real + "show x == 0\n",
      start + real + "show x =< 0\n",
      start + real + "show x < = 0\n",
      start + real + "show x ! = 0\n",
      start + real + "show not x = 0\n",
      start + real + "show (x > 0)\n",
      start + real + "show {x} > 0\n",
      start + real + "show {x > 0\n",
      start + real + "show x > 0}\n",
      start + real + "show x > 0 or\n",
      start + real + "show or x > 0\n",
      start + real + "show x > and\n",
      start + real + "show {} or x > 0\n",
      start + real + "show true\n",
      start + real + "show x\n",
      start + real + "show\n",
      start + real + "show 2x > 0\n",
      start + real + "show x^-1 > 0\n",
      start + real + "show x^0 > 0\n",
      start + real + "show x^65 > 0\n",
      start + real + "show x^01 > 0\n",
      start + real + "show x^(2) > 0\n",
      start + real + "show x^2^2 > 0\n",
      start + real + "show x/0 > 0\n",
      start + real + "show 1/(x - x) > 0\n",
      start + real + "show x^64*x^64*x^64*x^64 > 0\n",
      start + real + "show " + std::string(2'467, '9') + "*x > 0\n",
      start + real + "show " + chain(1'002) + " > 0\n",
      start + real + "show " + std::string(101, '(') + "x" + std::string(101, ')') + " > 0\n",
      start + real + "show " + std::string(101, '{') + "x > 0" + std::string(101, '}') + "\n",
      start + doubled + "show d15 and d15\n",
      start + "#" + std::string(1U << 20U, '=') + "\nshow false\n",
      start + real + "define d: x > 0\nlet y = d\n" + show,
      start + real + "let y = x\nshow y\n",
      start + real + "assume a: x > 0\nshow a\n",
      start + real + "let y = y\n" + show,
      start + real + "let y: x\n" + show,
      start + real + "define d = x > 0\n" + show,
      start + real + "exists u\nassume a: u > 0\n" + show,
      start + real + "exists u\nreal y\n" + show,
      start + real + "exists u\nexists v\n" + show,
      start + real + show + "show x > 1\n",
      start + real + show + "real y\n",
      start + "theorem u\n" + all,
      start + "Show 1 > 0\n",
  };
  for (const auto& [texts, are_good] : {std::pair(good, true), std::pair(bad, false)}) {
    for (const std::string& text : texts) {
      CAPTURE(text.substr(0, 300));
      CHECK(checker_reads(text) == are_good);
      CHECK(mistakes(text).empty() == are_good);
    }
  }
}

TEST_CASE("the prover takes for a statement what the checker takes for one") {
  constexpr int rounds = test::quick(30, 5);
  std::mt19937_64 random(20261121);
  int read = 0, refused = 0;
  for (const auto& file : statements_in(test::shipped_folder)) {
    const std::string text = test::read_file(file);
    if (text.size() > 2'000) continue;
    const Words lines = cut(text);
    for (int i = 0; i < rounds; ++i) {
      Words changed = lines;
      change(changed, random);
      if (i % 4 == 0) change(changed, random);
      const std::string mutant = joined(changed);
      const bool reads = checker_reads(mutant);
      CAPTURE(mutant);
      CHECK(mistakes(mutant).empty() == reads);
      ++(reads ? read : refused);
    }
  }
  CHECK(read > 10 * rounds);
  CHECK(refused > 10 * rounds);
}
