// Statements that are built as values, printed, and read again.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "base/expression/parser.hpp"
#include "proofs/statement/statement_text.hpp"

using namespace slipproof;

namespace {

Expression condition(const char* text) {
  return parse_expression(text, Sort::truth);
}

Expression number(const char* text) {
  return parse_expression(text, Sort::number);
}

}  // namespace

TEST_CASE("printed formulas: parts of one word are continued, others are braced") {
  const Expression a = condition("x > 0"), b = condition("y = 1"), c = condition("x != y");
  CHECK(formula_text(conjoined({a, nullptr, conjoined({b, c})})) == "x > 0 and y = 1 and x != y");
  CHECK(formula_text(conjoined({a, disjoined({b, c})})) == "x > 0 and {y = 1 or x != y}");
  CHECK(formula_text(disjoined({conjoined({a, b}), c})) == "{x > 0 and y = 1} or x != y");
  CHECK(formula_text(conjoined({a, braced(conjoined({b, c}))})) == "x > 0 and {y = 1 and x != y}");
  CHECK(formula_text(disjoined({braced(braced(a))})) == "{{x > 0}}");
  CHECK(formula_text(conjoined({make_symbol("sticks"), make_truth(false)})) == "sticks and false");
  CHECK(conjoined({nullptr}) == nullptr);
  CHECK(braced(nullptr) == nullptr);
  CHECK(has_cases(conjoined({a, disjoined({b, c})})));
  CHECK(!has_cases(conjoined({a, braced(b)})));
}

TEST_CASE("printed formulas: limits as people write them") {
  const auto between = [](const Expression& limit) {
    return formula_text(make_comparison({make(Operation::negate, {limit}), make_symbol("S"), limit},
                                        {Relation::less_equal, Relation::less_equal}));
  };
  CHECK(between(tight_product(make_symbol("mu"), make_symbol("N"))) == "-mu*N <= S <= mu*N");
  CHECK(between(tight_product(bracketed(number("mu / 2")), make_symbol("N"))) == "-(mu / 2)*N <= S <= (mu / 2)*N");
  CHECK(between(bracketed(number("q * W"))) == "-(q * W) <= S <= (q * W)");
  CHECK(between(number("q * W")) == "-(q * W) <= S <= q * W");
}

TEST_CASE("a printed statement is read as it was built") {
  WrittenStatement statement("T.1", "about a block");
  statement.declare(Directive::Kind::real, {"x", "mu"});
  statement.declare(Directive::Kind::real, {});
  statement.add(Directive::Kind::assume, "domain", condition("x > 0"));
  statement.add({{Directive::Kind::let, 0, {"half"}, number("x / 2")},
                 {Directive::Kind::define, 0, {"slides"}, condition("half < mu")}});
  statement.add_hints({make(Operation::subtract, {make_symbol("x"), bracketed(number("1"))}), nullptr});
  statement.declare(Directive::Kind::exists, {"y"});
  statement.show(conjoined({make_symbol("slides"), condition("y > x")}));
  CHECK(statement.variables() == 3);
  const std::string text = statement.text();
  CHECK(text ==
        "slipproof-statement 1\ntheorem T.1\n# about a block\nreal x mu\nassume domain: x > 0\nlet half = x / 2\n"
        "define slides: half < mu\n# split: x - (1)\nexists y\nshow slides and y > x\n");
  const StatementText read = read_statement("T.1", text);
  CHECK(read.directives.size() == 6);
  CHECK(read.hints.size() == 1);
  CHECK(same(read.directives[2].body, number("x / 2")));
}
