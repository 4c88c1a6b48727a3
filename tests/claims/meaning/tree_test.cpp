// The section "Values" of proofs/MEANING.md, and "closure", sentence by sentence.
#include <doctest/doctest.h>

#include "claims/meaning/second_judge/second_judge.hpp"

using namespace slipproof;

namespace {

meaning::Tree over_zero() {
  return meaning::over(meaning::number(1), meaning::number(0));
}

meaning::Number value(const meaning::Tree& tree) {
  return meaning::number_of(tree, {{{"x", 0}}, {{"d", over_zero()}}});
}

meaning::Truth truth(const meaning::Tree& tree) {
  return meaning::truth_of(tree, {{{"x", 0}}, {{"d", over_zero()}}});
}

}  // namespace

TEST_CASE("the second judge's numbers are undefined where the page says so") {
  using namespace meaning;
  const Tree zero = number(0), one = number(1), x = symbol("x");
  CHECK_FALSE(value(over_zero()));
  CHECK_FALSE(value(symbol("d")));
  CHECK_FALSE(value(times(zero, over_zero())));
  CHECK_FALSE(value(make(Op::maximum, {one, over_zero()})));
  CHECK_FALSE(value(power(over_zero(), 0)));
  CHECK_FALSE(value(power(x, -1)));
  CHECK_FALSE(value(over(x, x)));
  CHECK_FALSE(value(over(one, over(one, x))));
  CHECK(value(power(x, 0)) == Rational(1));
}

TEST_CASE("the second judge's conditions are undefined where the page says so") {
  using namespace meaning;
  const Tree zero = number(0), one = number(1), undefined = compare(over_zero(), ">", zero);
  const Tree yes = meaning::truth(true), no = meaning::truth(false);
  CHECK_FALSE(::truth(undefined));
  CHECK_FALSE(::truth(make(Op::negation, {undefined})));
  CHECK_FALSE(::truth(make(Op::conjunction, {yes, undefined})));
  CHECK_FALSE(::truth(make(Op::disjunction, {undefined, no})));
  CHECK_FALSE(::truth(chain({zero, one, over_zero()}, {"<", "<"})));
  CHECK(is_false(::truth(chain({one, zero, over_zero()}, {"<", "<"}))));
  CHECK(is_false(::truth(make(Op::conjunction, {undefined, no}))));
  CHECK(is_true(::truth(make(Op::disjunction, {undefined, yes}))));
}

TEST_CASE("the second judge carries `not` inwards, and adds the ends") {
  using namespace meaning;
  const Tree x = symbol("x"), y = symbol("y");
  CHECK(text(closure(compare(x, "<", y))) == "(x <= y)");
  CHECK(text(closure(make(Op::negation, {compare(x, "<", y)}))) == "(x >= y)");
  CHECK(text(closure(make(Op::negation, {chain({x, y, x}, {"<=", "="})}))) == "((x >= y) or ((y <= x) or (y >= x)))");
  const Tree both = make(Op::conjunction, {compare(x, "=", y), meaning::truth(true)});
  CHECK(text(closure(make(Op::negation, {both}))) == "(((x <= y) or (x >= y)) or false)");
}
