// The verdict on an answer from what is known of all solutions: exact ones, boxes, families.
#include <doctest/doctest.h>

#include "contact/judge/all_solutions_json.hpp"

using namespace slipproof;

namespace {

FoundSolution solution(const Rational& lower, const Rational& upper) {
  FoundSolution found;
  found.modes = {"slip+"};
  found.r = {{lower, upper}, {0, 0}};
  found.u = {{0, 0}, {lower, std::nullopt}};
  return found;
}

}  // namespace

TEST_CASE("the verdict on an answer follows from all solutions, and is undecided while others may be somewhere") {
  AllSolutions all;
  all.dimension = 2;
  CHECK(all.verdict(nullptr) == ContactVerdict::no_solution);
  all.solutions = {solution(1, 2)};
  CHECK(all.one());
  CHECK(all.verdict(all.solutions.data()) == ContactVerdict::unique);
  CHECK(all.verdict(nullptr) == ContactVerdict::wrong);
  all.unexamined = {"stick/slip from 0 to 90 degrees"};
  CHECK(all.verdict(all.solutions.data()) == ContactVerdict::solution_within_rho);
  CHECK(all.verdict(nullptr) == ContactVerdict::undecided);
  all.solutions.push_back(solution(3, 4));
  CHECK(all.verdict(all.solutions.data()) == ContactVerdict::ambiguous);
  all.solutions[1].exists = false;
  CHECK(all.verdict(all.solutions.data()) == ContactVerdict::solution_within_rho);
  CHECK(all.verdict(&all.solutions[1]) == ContactVerdict::undecided);
  all.unexamined.clear();
  all.solutions.pop_back();
  all.solutions[0].alone = false;
  CHECK(all.verdict(all.solutions.data()) == ContactVerdict::solution_within_rho);
  all.solutions[0] = solution(1, 1);
  all.solutions[0].u = points({0, 1});
  all.solutions[0].open_directions = 1;
  CHECK(all.singles() == 0);
  CHECK(all.verdict(all.solutions.data()) == ContactVerdict::solution_within_rho);  // one motion, by other forces
  CHECK(all.one_motion());
  CHECK_FALSE(all.one());
  all.solutions[0].moves = true;
  CHECK(all.verdict(all.solutions.data()) == ContactVerdict::ambiguous);
  CHECK_FALSE(all.one_motion());
  all.solutions[0].moves = false;
  all.solutions.push_back(all.solutions[0]);
  CHECK(all.verdict(all.solutions.data()) == ContactVerdict::solution_within_rho);
  all.dimension = 1;  // there forces are asked for
  CHECK(all.verdict(all.solutions.data()) == ContactVerdict::ambiguous);
  all.dimension = 2;
  all.solutions[1] = solution(2, 2);
  CHECK(all.verdict(all.solutions.data()) == ContactVerdict::ambiguous);
}

TEST_CASE("a number that is known is a text, one between bounds a pair, and an infinite bound is null") {
  AllSolutions all;
  all.solutions = {solution(1, 1), solution(Rational(1, 3), Rational(1, 2))};
  all.solutions[1].open_directions = 2;
  Json to;
  add_solutions(all, to);
  CHECK(to["found"].size() == 1);
  CHECK(to["found"][0]["z"] == Json({"1", "0"}));
  CHECK(to["found"][0]["w"] == Json::array({"0", Json::array({"1", nullptr})}));
  CHECK(to["continua"][0]["parameters"] == 2);
  CHECK(to["continua"][0]["nearest_z"] == Json::array({Json::array({"1/3", "1/2"}), "0"}));
}
