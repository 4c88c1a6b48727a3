#include "base/expression/evaluate.hpp"

#include <doctest/doctest.h>

#include <map>
#include <string>
#include <vector>

#include "base/expression/random_expression.hpp"
#include "support/papers/formula.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

const std::vector<std::string> abc_zero{"a", "b", "c", "zero"};

Scope plain_scope() {
  Scope scope;
  for (const auto& name : abc_zero) scope.slots.push_back({name, std::nullopt});
  return scope;
}

Evaluator<Rational> at(const Scope& scope, const Rational& a, const Rational& b, const Rational& c) {
  Evaluator<Rational> evaluator(scope);
  evaluator.set(0, a);
  evaluator.set(1, b);
  evaluator.set(2, c);
  evaluator.set(3, Rational(0));
  return evaluator;
}

// The same meaning, written the plain way, on the tree: numbers with an exception where there is none.
struct Nothing {};

Rational plain(const Expression& expression, const std::map<std::string, Rational>& values) {
  const auto operand = [&](std::size_t i) { return plain(expression->operands[i], values); };
  switch (expression->operation) {
    case Operation::number:
      return expression->number;
    case Operation::symbol:
      return values.at(expression->symbol);
    case Operation::negate:
      return 0 - operand(0);
    case Operation::add:
      return operand(0) + operand(1);
    case Operation::subtract:
      return operand(0) - operand(1);
    case Operation::multiply:
      return operand(0) * operand(1);
    case Operation::divide: {
      const Rational x = operand(0), y = operand(1);
      if (y == 0) throw Nothing{};
      return x / y;
    }
    case Operation::power: {
      const Rational x = operand(0);
      Rational product = 1;
      for (int i = 0; i < std::abs(expression->exponent); ++i) product *= x;
      if (expression->exponent < 0 && product == 0) throw Nothing{};
      return expression->exponent < 0 ? Rational(1 / product) : product;
    }
    case Operation::absolute: {
      const Rational x = operand(0);
      return x < 0 ? Rational(-x) : x;
    }
    case Operation::signum: {
      const Rational x = operand(0);
      return x < 0 ? -1 : x > 0 ? 1 : 0;
    }
    case Operation::minimum:
    case Operation::maximum: {
      const Rational x = operand(0), y = operand(1);
      return (expression->operation == Operation::minimum) == (x < y) ? x : y;
    }
    default:
      throw std::logic_error("no number");
  }
}

}  // namespace

TEST_CASE("numbers agree with a plain walk over the tree") {
  testing::RandomExpressions random(2, abc_zero);
  const Scope scope = plain_scope();
  int undefined = 0;
  for (int i = 0; i < 4000; ++i) {
    const Expression expression = random.number(random.below(5));
    CAPTURE(to_string(expression));
    const Rational a = random.rational(-4, 5, 3), b = random.rational(-4, 5, 1), c = random.rational(1, 2, 5);
    const Value<Rational> value = at(scope, a, b, c).number(compile(expression, abc_zero));
    try {
      const Rational expected = plain(expression, {{"a", a}, {"b", b}, {"c", c}, {"zero", 0}});
      REQUIRE(value.number);
      CHECK(*value.number == expected);
    } catch (const Nothing&) {
      ++undefined;
      CHECK_FALSE(value.number);
      CHECK(value.failure == Failure::undefined);
    }
  }
  CHECK(undefined > 100);
}

TEST_CASE("truth is Kleene's") {
  const Scope scope = plain_scope();
  auto evaluator = at(scope, 1, 2, 3);
  const auto value = [&](const std::string& text) { return evaluator.truth(compile(truth(text), abc_zero)); };
  CHECK(value("a < b") == Truth::yes);
  CHECK(value("a < b < c") == Truth::yes);
  CHECK(value("a < c < b") == Truth::no);
  CHECK(value("a <= 1 >= a = 1 != b") == Truth::yes);
  CHECK(value("not a < b") == Truth::no);
  CHECK(value("1/zero < 2") == Truth::undefined);
  CHECK(value("not 1/zero < 2") == Truth::undefined);
  CHECK(value("1/zero < 2 and a > b") == Truth::no);
  CHECK(value("a > b and 1/zero < 2") == Truth::no);
  CHECK(value("1/zero < 2 or a < b") == Truth::yes);
  CHECK(value("1/zero < 2 or a > b") == Truth::undefined);
  CHECK(value("1/zero < 2 and a < b") == Truth::undefined);
  CHECK(value("0 < 1/zero < 2") == Truth::undefined);
  CHECK(value("5 < a < 1/zero") == Truth::no);
}

TEST_CASE("powers") {
  const Scope scope = plain_scope();
  auto evaluator = at(scope, Rational(2, 3), 2, 3);
  CHECK(*evaluator.number(compile(number("a^5"), abc_zero)).number == Rational(32, 243));
  CHECK(*evaluator.number(compile(number("a^-3"), abc_zero)).number == Rational(27, 8));
  CHECK(*evaluator.number(compile(number("zero^0"), abc_zero)).number == 1);
  CHECK_FALSE(evaluator.number(compile(number("zero^-1"), abc_zero)).number);
}

TEST_CASE("definitions are evaluated when used, and once") {
  const std::vector<std::string> symbols{"a", "broken", "twice"};
  Scope scope;
  scope.slots.push_back({"a", std::nullopt});
  scope.slots.push_back({"broken", compile(number("1/(a - a)"), symbols)});
  scope.slots.push_back({"twice", compile(number("2*a"), symbols)});
  Evaluator<Rational> evaluator(scope);
  evaluator.set(0, Rational(3));
  const auto truth_of = [&](const std::string& text) { return evaluator.truth(compile(truth(text), symbols)); };
  CHECK(truth_of("twice = 6 or broken > 0") == Truth::yes);
  CHECK(truth_of("broken > 0") == Truth::undefined);
  evaluator.set(0, Rational(4));
  CHECK(*evaluator.at(2).number == 6);
  evaluator.reset();
  CHECK(truth_of("a = 4") == Truth::undecided);
  evaluator.set(0, Rational(4));
  CHECK(*evaluator.at(2).number == 8);
}
