// The prover takes for a statement what the checker takes for one.
#include <doctest/doctest.h>

#include <random>
#include <sstream>
#include <utility>
#include <vector>

#include "proofs/search/prove_files.hpp"
#include "proofs/search/statement_mistakes.hpp"
#include "support/how_many.hpp"
#include "support/papers/shipped.hpp"
#include "support/run_program.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

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
  constexpr int rounds = test::quick(10, 5);
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
