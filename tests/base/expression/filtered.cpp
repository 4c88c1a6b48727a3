#include "base/expression/filtered.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "base/expression/random_expression.hpp"
#include "base/expression/sure_condition.hpp"
#include "support/papers/formula.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

const std::vector<std::string> letters{"a", "b", "c"};

std::optional<std::size_t> place_of(std::string_view name) {
  for (std::size_t i = 0; i < letters.size(); ++i) {
    if (letters[i] == name) return i;
  }
  return letters.size();
}

/// a, b, c, and `d` as a definition, so that a change of a symbol has something to reach.
Scope with_definition(const Expression& d) {
  Scope scope;
  for (const std::string& letter : letters) scope.slots.push_back({letter, std::nullopt});
  scope.slots.push_back({"d", Program(d, place_of)});
  return scope;
}

Truth exact_truth(const Scope& scope, const std::vector<Rational>& values, const Program& statement) {
  Evaluator<Rational> evaluator(scope);
  for (std::size_t k = 0; k < values.size(); ++k) evaluator.set(k, values[k]);
  return evaluator.truth(statement);
}

}  // namespace

TEST_CASE("what binary64 says of a statement is what exact arithmetic says, or nothing") {
  testing::RandomExpressions random(64, {"a", "b", "c", "d"});
  int said = 0, open = 0;
  for (int i = 0; i < 3000; ++i) {
    const Scope scope = with_definition(testing::RandomExpressions(static_cast<unsigned>(i), letters).number(2));
    const Program statement(random.truth(4), place_of);
    std::vector<Rational> values;
    for (std::size_t k = 0; k < letters.size(); ++k) values.push_back(random.rational(-6, 7, 9));
    FilteredEvaluator filtered(scope);
    filtered.set(0, values);
    CHECK(filtered.truth(statement) == exact_truth(scope, values, statement));
    const Truth exact = exact_truth(scope, values, statement);
    Evaluator<Approximate> nearby(scope);
    for (std::size_t k = 0; k < values.size(); ++k) nearby.set(k, Approximate(values[k]));
    const Truth sure = nearby.truth(statement);
    if (sure != Truth::undecided) CHECK(sure == exact);
    (sure == Truth::undecided ? open : said) += 1;
  }
  CHECK(said > 4 * open);
}

TEST_CASE("a condition in straight-line code is as exact arithmetic has it, or open, whatever changed") {
  testing::RandomExpressions random(65, {"a", "b", "c", "d"});
  int said = 0, open = 0;
  for (int i = 0; i < 2000; ++i) {
    const Scope scope = with_definition(testing::RandomExpressions(static_cast<unsigned>(i), letters).number(2));
    const Program statement(random.truth(4), place_of);
    SureCondition condition(scope, statement, 0, letters.size());
    std::vector<Rational> values(letters.size());
    std::vector<Approximate> near(letters.size());
    const auto change = [&](std::size_t k) {
      values[k] = random.rational(-6, 7, 9);
      near[k] = Approximate(values[k]);
      condition.changed(k);
    };
    for (std::size_t k = 0; k < letters.size(); ++k) change(k);
    for (int turn = 0; turn < 5; ++turn) {
      const Truth sure = condition.truth(near), exact = exact_truth(scope, values, statement);
      if (sure != Truth::undecided) CHECK(sure == exact);
      if (exact != Truth::undefined) (sure == Truth::undecided ? open : said) += 1;
      for (int changes = 0; changes < turn; ++changes) change(static_cast<std::size_t>(random.below(3)));
    }
  }
  CHECK(said > 4 * open);
}

TEST_CASE("an equation that has to hold says what a coordinate has to be, and no other does") {
  const Scope scope = with_definition(make_number(0));
  const auto demanded = [&](const char* text) {
    SureCondition condition(scope, Program(parse_expression(text, Sort::truth), place_of), 0, letters.size());
    condition.truth({Approximate(2), Approximate(3), Approximate(5)});
    std::vector<double> all;
    for (std::size_t k = 0; k < letters.size(); ++k) {
      const Approximate* const number = condition.demanded(k);
      all.push_back(number != nullptr ? number->value : 0);
    }
    return all;
  };
  CHECK(demanded("a = b + c") == std::vector<double>{8, 0, 0});
  CHECK(demanded("a > 0 and (b*c = a and c > 1)") == std::vector<double>{15, 0, 0});
  CHECK(demanded("a = -(b + c)/(b - c)") == std::vector<double>{4, 0, 0});
  CHECK(demanded("a = b") == std::vector<double>{3, 2, 0});
  CHECK(demanded("a = b and c = 7") == std::vector<double>{3, 2, 7});
  for (const char* const none : {"a = a*b", "not a = b", "a = b or c > 0", "a > b", "a != b", "2*a = b + c"}) {
    CAPTURE(none);
    CHECK(demanded(none) == std::vector<double>{0, 0, 0});
  }
}

TEST_CASE("an equation that holds but for roundings is left to exact arithmetic") {
  const Scope scope = with_definition(make_number(0));
  const Program equation(make_comparison({make(Operation::add, {make_symbol("a"), make_symbol("b")}), make_symbol("c")},
                                         {Relation::equal}),
                         place_of);
  const std::vector<Rational> values{Rational(1, 3), Rational(1, 10), Rational(13, 30)};
  Evaluator<Approximate> nearby(scope);
  for (std::size_t k = 0; k < values.size(); ++k) nearby.set(k, Approximate(values[k]));
  CHECK(nearby.truth(equation) == Truth::undecided);
  FilteredEvaluator filtered(scope);
  filtered.set(0, values);
  CHECK(filtered.truth(equation) == Truth::yes);
}
