// What people read of an answer to a small contact problem: how many solutions there are, and how they differ.
#include "report/scenes/contact_words.hpp"

#include <doctest/doctest.h>

#include "contact/formats/json_problem.hpp"

using namespace slipproof;

namespace {

std::string words(const std::string& problem) {
  ContactFileOptions options;
  options.judge.refine = true;
  return contact_words(judge_problem_file("p.json", read_json_problem(problem, "p.json"), options), 0);
}

void check_has(const std::string& text, const std::string& part) {
  CAPTURE(text);
  CHECK(text.find("  " + part + "\n") != std::string::npos);
}

}  // namespace

TEST_CASE("the words say how many solutions a small problem has, in which modes, and where they differ most") {
  // z = (1, 0) with w = (0, 1), z = (0, 1) with w = (1, 0), z = (1/3, 1/3) with w = 0.
  check_has(words(R"({"M":[[1,2],[2,1]],"q":[-1,-1],"z":[1,0]})"),
            "The problem has 3 solutions: zz, zw, wz. Their forces differ by up to 1.00e+00 at contact 1, their "
            "velocities differ by up to 1.00e+00 at contact 1.");
  check_has(words(R"({"M":[[2]],"q":[-1],"z":[0.5]})"), "The problem has 1 solution: z.");
  check_has(words(R"({"M":[[0]],"q":[0],"z":[0.5]})"),
            "The problem has 1 continuum of solutions: z along 1 direction.");
  check_has(words(R"({"M":[[1,1],[1,1]],"q":[-1,-1],"z":[0.5,0.5]})"),
            "The problem has 1 continuum of solutions: zz along 1 direction.");
}

TEST_CASE("of a wrong answer the words say by how much its mode fails") {
  const std::string wrong = words(R"({"M":[[2,1],[1,2]],"q":[-5,-6],"z":[2.5,0]})");
  check_has(wrong, "The answer suggests the mode zw: w2 >= 0 is violated by 3.50e+00.");
  check_has(wrong, "The problem has 1 solution: zz.");
  check_has(words(R"({"M":[[-1]],"q":[-1],"z":[0]})"), "It is proved that there is no solution.");
}
