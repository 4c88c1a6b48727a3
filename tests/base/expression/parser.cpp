#include "base/expression/parser.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "base/expression/random_expression.hpp"
#include "support/papers/formula.hpp"

using namespace slipproof;
using namespace slipproof::test;

TEST_CASE("operators bind as in mathematics") {
  // Left: as written; right: the same with every grouping spelled out.
  const std::vector<std::pair<std::string, std::string>> numbers{
      {"a + b*c", "a + (b*c)"},
      {"a - b - c", "(a - b) - c"},
      {"a/b/c", "(a/b)/c"},
      {"a/b*c", "(a/b)*c"},
      {"-a^2", "-(a^2)"},
      {"2*-a", "2*(-a)"},
      {"-a*b", "(-a)*b"},
      {"a^-2*b", "(a^(-2))*b"},
      {"- -a", "-(-a)"},
      {"f*h*(2*M1)", "(f*h)*(2*M1)"},
      {"min(a, b + 1)", "min(a, (b + 1))"},
  };
  for (const auto& [written, grouped] : numbers) {
    const std::string& text = written;  // clang 14 captures no structured binding
    CAPTURE(text);
    CHECK(same(number(text), number(grouped)));
  }
  const std::vector<std::pair<std::string, std::string>> truths{
      {"a < b and c < d or not e = 1", "((a < b) and (c < d)) or (not (e = 1))"},
      {"not a < b and true", "(not (a < b)) and true"},
      {"a + 1 < b*c", "(a + 1) < (b*c)"},
  };
  for (const auto& [written, grouped] : truths) {
    const std::string& text = written;  // clang 14 captures no structured binding
    CAPTURE(text);
    CHECK(same(truth(text), truth(grouped)));
  }
  CHECK_FALSE(same(number("a - (b - c)"), number("a - b - c")));
  CHECK_FALSE(same(number("(-a)^2"), number("-a^2")));
}

TEST_CASE("a chain keeps its links") {
  const Expression chain = truth("0 < b <= b1 != 3");
  REQUIRE(chain->operation == Operation::compare);
  CHECK(chain->operands.size() == 4);
  CHECK(chain->relations == std::vector{Relation::less, Relation::less_equal, Relation::not_equal});
}

TEST_CASE("nodes remember their columns") {
  const Expression product = number("  f * h0");
  CHECK(product->column == 5);
  CHECK(product->operands[0]->column == 3);
  CHECK(product->operands[1]->column == 7);
}

TEST_CASE("literals are exact") {
  CHECK(number("0.1")->number == Rational(1, 10));
  CHECK(number("1e-3")->number == Rational(1, 1000));
  CHECK(number("0x1.8p-3")->number == Rational(3, 16));
  CHECK(number("0xe-3")->operation == Operation::subtract);
  CHECK(number(".5")->number == Rational(1, 2));
}

TEST_CASE("printing reads back as the same tree") {
  testing::RandomExpressions random(1, {"a", "b1", "M0", "xi_3"});
  for (int i = 0; i < 3000; ++i) {
    const Expression expression = i % 2 == 0 ? random.number(random.below(6)) : random.truth(random.below(6));
    const std::string text = to_string(expression);
    CAPTURE(text);
    CHECK(same(parse_expression(text, sort(*expression)), expression));
  }
  CHECK(to_string(number("f*g*(2*b+f*R)/(b11*0.25)")) == "f * g * (2 * b + f * R) / (b11 * 0.25)");
  CHECK(to_string(truth("0<b  and not b<=b1")) == "0 < b and not b <= b1");
}

TEST_CASE("substitution replaces every occurrence and shares the rest") {
  const Expression where = number("b*(h + b)/R");
  CHECK(same(substitute(where, "b", number("f + 1")), number("(f + 1)*(h + (f + 1))/R")));
  CHECK(substitute(where, "absent", number("1")) == where);
  CHECK(symbols(where) == std::vector<std::string>{"b", "h", "R"});
}

TEST_CASE("mistakes are told with their place") {
  struct Mistake {
    std::string text;
    Sort expected;
    std::size_t column;
    std::string message;
  };
  const std::string deep = std::string(201, '(') + "1" + std::string(201, ')');
  std::string wide = "1";
  for (int i = 0; i < 200; ++i) wide += "+1";
  const std::vector<Mistake> mistakes{
      {"", Sort::number, 1, "found the end, expected a number, a symbol or `(`"},
      {"a +", Sort::number, 4, "found the end, expected a number, a symbol or `(`"},
      {"a b", Sort::number, 3, "found `b`, expected an operator or the end of the expression"},
      {"a * / b", Sort::number, 5, "found `/`, expected a number, a symbol or `(`"},
      {"(a + b", Sort::number, 7, "found the end, expected `)`"},
      {"a + b)", Sort::number, 6, "found `)`, expected an operator or the end of the expression"},
      {"a == b", Sort::truth, 3, "found `==`, expected an operator or the end of the expression"},
      {"a < ", Sort::truth, 5, "found the end, expected a number, a symbol or `(`"},
      {"f(h + 1)", Sort::number, 1,
       "found `f(`, expected one of the functions abs, sign, min, max (a product is written with `*`)"},
      {"abs", Sort::number, 4, "found the end, expected `(` after the function `abs`"},
      {"abs(a, b)", Sort::number, 6, "found `,`, expected `)`"},
      {"min(a)", Sort::number, 6, "found `)`, expected `,` and a second argument"},
      {"a^b", Sort::number, 3, "found `b`, expected an integer exponent"},
      {"a^0.5", Sort::number, 3, "found the exponent 0.5, expected an integer"},
      {"a^65", Sort::number, 3, "found the exponent 65, expected one of at most 64"},
      {"a^2^3", Sort::number, 4, "found `^`, expected parentheses: `x^2^3` reads two ways"},
      {"a + (b < c)", Sort::number, 8, "found a comparison or truth value, expected a number"},
      {"a < b", Sort::number, 3, "found a comparison or truth value, expected a number"},
      {"a + b", Sort::truth, 3, "found a number, expected a comparison or truth value"},
      {"a and b < c", Sort::truth, 1, "found a number, expected a comparison or truth value"},
      {"not a", Sort::truth, 5, "found a number, expected a comparison or truth value"},
      {"a < (b < c)", Sort::truth, 8, "found a comparison or truth value, expected a number"},
      {"a $ b", Sort::number, 3, "found `$`, expected an operator or the end of the expression"},
      {"\xce\xb7", Sort::number, 1, "found `\xce\xb7` (U+03B7; write `eta`), expected a number, a symbol or `(`"},
      {"\xc2\xb5*N", Sort::number, 1, "found `\xc2\xb5` (U+00B5; write `mu`), expected a number, a symbol or `(`"},
      {"a + \xce\xbc", Sort::number, 5, "found `\xce\xbc` (U+03BC; write `mu`), expected a number, a symbol or `(`"},
      {"a \xe2\x88\x92 b", Sort::number, 3,
       "found `\xe2\x88\x92` (U+2212; write `-`), expected an operator or the end of the expression"},
      {"a \xe2\x89\xa4 b", Sort::truth, 3,
       "found `\xe2\x89\xa4` (U+2264; write `<=`), expected an operator or the end of the expression"},
      {"\xe2\x80\xae", Sort::number, 1, "found U+202E, expected a number, a symbol or `(`"},
      {"\xff", Sort::number, 1, "found a byte of value 255, expected a number, a symbol or `(`"},
      {"and", Sort::truth, 1, "found `and`, expected a number, a symbol or `(`"},
      {deep, Sort::number, 201, "nested more than 200 levels deep"},
      {wide, Sort::number, 400, "nested more than 200 levels deep"},
      {std::string(100'000, '-') + "1", Sort::number, 10'001,
       "found an expression of 100001 characters, expected at most 10000"},
      {std::string(9'000, '-') + "1", Sort::number, 201, "nested more than 200 levels deep"},
  };
  for (const Mistake& mistake : mistakes) {
    CAPTURE(mistake.text.substr(0, 80));
    try {
      parse_expression(mistake.text, mistake.expected);
      FAIL("accepted");
    } catch (const ExpressionError& error) {
      CHECK(error.column() == mistake.column);
      CHECK(std::string(error.what()) == mistake.message);
    }
  }
}

TEST_CASE("malformed and monstrous numbers are refused where they stand") {
  for (const std::string text : {"1 + 2b", "1 + 1e999999999", "1 + 1.2.3", "1 + 0x", "1 + 1e", "1 + 12__3"}) {
    CAPTURE(text);
    try {
      number(text);
      FAIL("accepted");
    } catch (const ExpressionError& error) {
      CHECK(error.column() >= 5);
      CHECK(std::string(error.what()).find("expected") != std::string::npos);
    }
  }
}

TEST_CASE("names of symbols") {
  for (const char* name : {"b", "b11", "xi_1", "M0", "aX9_"}) CHECK(is_symbol_name(name));
  for (const char* name : {"", "_b", "1b", "b-1", "and", "true", "abs", "b 1", "\xce\xb7"})
    CHECK_FALSE(is_symbol_name(name));
}
