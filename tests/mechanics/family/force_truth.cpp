#include "mechanics/family/force_truth.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "base/expression/random_expression.hpp"
#include "support/papers/formula.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

const std::vector<std::string> force_a_b{"F", "a", "b"};

struct ForceSetting {
  Scope scope{{{"F", {}}, {"a", {}}, {"b", {}}}};
  Evaluator<ForceFunction> functions{scope};
  Evaluator<Rational> numbers{scope};

  ForceSetting(const Rational& a, const Rational& b) {
    functions.set(0, RationalFunction::variable());
    functions.set(1, RationalFunction(a));
    functions.set(2, RationalFunction(b));
    numbers.set(1, a);
    numbers.set(2, b);
  }
  std::string cells(const std::string& statement) {
    std::string text;
    constexpr const char* words[] = {"no", "yes", "undefined", "undecided"};
    for (const TruthCell& cell : truth_over_forces(compile(truth(statement), force_a_b), functions)) {
      text += to_string(cell.forces) + " " + words[static_cast<int>(cell.truth)] + "; ";
    }
    return text;
  }
};

}  // namespace

TEST_CASE("the line of forces is cut where the truth changes") {
  ForceSetting at(2, 6);
  CHECK(at.cells("0 < F*a < b") == "(-oo, 0] no; (0, 3) yes; [3, +oo) no; ");
  CHECK(at.cells("0 <= F*a <= b") == "(-oo, 0) no; [0, 3] yes; (3, +oo) no; ");
  CHECK(at.cells("F = a or F > b") == "(-oo, 2) no; {2} yes; (2, 6] no; (6, +oo) yes; ");
  CHECK(at.cells("F != a") == "(-oo, 2) yes; {2} no; (2, +oo) yes; ");
  CHECK(at.cells("a < b") == "(-oo, +oo) yes; ");
  CHECK(at.cells("1/F > 0") == "(-oo, 0) no; {0} undefined; (0, +oo) yes; ");
  CHECK(at.cells("(F - 1)/(F + 1) < 0") == "(-oo, -1) no; {-1} undefined; (-1, 1) yes; [1, +oo) no; ");
  CHECK(at.cells("F > 1/(a - 2)") == "(-oo, +oo) undefined; ");
  CHECK(at.cells("F > 1/(a - 2) and F > 3") == "(-oo, 3] no; (3, +oo) undefined; ");
  CHECK(at.cells("F^2 > 1") == "(-oo, -1) yes; [-1, 1] no; (1, +oo) yes; ");
  CHECK(at.cells("F^2 >= 0") == "(-oo, +oo) yes; ");
  CHECK(at.cells("F^2 > 2") == "(-oo, +oo) undecided; ");  // irrational ends
  CHECK(at.cells("F/F = 1") == "(-oo, 0) yes; {0} undefined; (0, +oo) yes; ");
  CHECK(at.cells("1/(1/(F - 3)) = F - 3") == "(-oo, 3) yes; {3} undefined; (3, +oo) yes; ");
  CHECK(at.cells("max(1, 1 + (F - F)/F) = 1") == "(-oo, 0) yes; {0} undefined; (0, +oo) yes; ");
  CHECK(at.cells("(1/F)^0 = 1") == "(-oo, 0) yes; {0} undefined; (0, +oo) yes; ");
  CHECK(at.cells("abs(F) > 1") == "(-oo, +oo) undecided; ");
}

TEST_CASE("one interval, or none claimed") {
  ForceSetting at(2, 6);
  const auto interval = [&](const std::string& statement, const ForceInterval& within) {
    const auto found = true_interval(compile(truth(statement), force_a_b), at.functions, within);
    return found ? to_string(*found) : "-";
  };
  const ForceInterval positive = ForceInterval::open_between(Rational(0), std::nullopt);
  CHECK(interval("F*a < b", positive) == "(0, 3)");
  CHECK(interval("F < 0", positive) == "{}");
  CHECK(interval("F != 5", positive) == "-");
  CHECK(interval("1/F > 0", positive) == "(0, +oo)");
  CHECK(interval("1/F > 0", {}) == "-");
  CHECK(interval("F^2 > 1", positive) == "(1, +oo)");
  CHECK(interval("F^2 > 2", positive) == "-");
}

TEST_CASE("every cell says what evaluation at a force says") {
  testing::RandomExpressions random(3, force_a_b);
  int decided = 0;
  for (int i = 0; i < 2000; ++i) {
    const Rational a = random.rational(-3, 4, 1);
    ForceSetting at(a, random.rational(1, 2, 4));
    const Expression statement = random.truth(1 + random.below(3));
    CAPTURE(to_string(statement));
    const Program program = compile(statement, force_a_b);
    for (const TruthCell& cell : truth_over_forces(program, at.functions)) {
      if (cell.truth == Truth::undecided) continue;
      at.numbers.reset();
      at.numbers.set(0, cell.forces.sample());
      at.numbers.set(1, at.functions.at(1).number->value().numerator().coefficient(0));
      at.numbers.set(2, at.functions.at(2).number->value().numerator().coefficient(0));
      const Truth there = at.numbers.truth(program);
      CAPTURE(to_string(cell.forces));
      CHECK(cell.truth == there);
      ++decided;
    }
  }
  CHECK(decided > 500);
}
