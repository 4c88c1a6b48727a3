#include "claims/mutation/mutate.hpp"

#include <doctest/doctest.h>

#include <set>

#include "base/expression/parser.hpp"
#include "base/expression/random_expression.hpp"

using namespace slipproof;

namespace {

std::set<std::string> texts(const std::string& expression, Sort sort, const std::vector<std::string>& symbols = {}) {
  std::set<std::string> result;
  for (const Mutant& mutant : mutants(parse_expression(expression, sort), symbols)) {
    result.insert(to_string(mutant.expression));
  }
  return result;
}

}  // namespace

TEST_CASE("every single change, by hand") {
  CHECK(texts("2", Sort::number) == std::set<std::string>{"3", "1", "4", "-2"});
  CHECK(texts("0", Sort::number) == std::set<std::string>{"1", "-1"});
  CHECK(texts("b", Sort::number, {"b", "h"}) == std::set<std::string>{"2 * b", "-b", "h"});
  CHECK(texts("f/h", Sort::number) ==
        std::set<std::string>{"f * h", "h / f", "2 * f / h", "-f / h", "f / (2 * h)", "f / -h"});
  CHECK(texts("b^2", Sort::number) == std::set<std::string>{"b^3", "b^1", "b^-2", "(2 * b)^2", "(-b)^2"});
  CHECK(texts("0 < b", Sort::truth) ==
        std::set<std::string>{"0 <= b", "0 > b", "1 < b", "-1 < b", "0 < 2 * b", "0 < -b"});
  const auto chain = texts("0 < b <= c", Sort::truth);
  CHECK(chain.contains("0 < b"));
  CHECK(chain.contains("b <= c"));
  CHECK(chain.contains("0 < b < c"));
  CHECK(chain.contains("0 < b >= c"));
  CHECK(texts("true and not false", Sort::truth) == std::set<std::string>{"true or not false", "true", "not false",
                                                                          "false and not false", "true and false",
                                                                          "true and not true"});
  const auto conditions = texts("a < 1 or b < 1 and c < 1", Sort::truth);
  for (const char* left : {"a < 1 or b < 1", "a < 1 or c < 1", "b < 1 and c < 1", "a < 1"}) {
    CHECK(conditions.contains(left));
  }
}

TEST_CASE("mutants differ from the original and from each other, and can be read back") {
  testing::RandomExpressions random(4, {"a", "b", "c"});
  for (int i = 0; i < 200; ++i) {
    const Expression original = i % 2 == 0 ? random.number(3) : random.truth(3);
    CAPTURE(to_string(original));
    const auto all = mutants(original, {"a", "b", "c"});
    CHECK(all.size() >= 1);
    std::set<std::string> seen{to_string(original)};
    for (const Mutant& mutant : all) {
      const std::string text = to_string(mutant.expression);
      CAPTURE(text);
      CHECK(seen.insert(text).second);
      CHECK(same(parse_expression(text, sort(*original)), mutant.expression));
      CHECK_FALSE(mutant.description.empty());
    }
  }
}
