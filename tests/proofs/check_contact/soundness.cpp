// Problems whose solutions are known, or can be listed, in exact arithmetic: what is accepted is true of them.
#include "proofs/check_contact/examples.hpp"
#include "proofs/check_contact/known_problems.hpp"

using namespace slipproof::check_contact;

TEST_CASE("where there is a solution nearby none is denied, and it is accepted itself") {
  for (int i = 0; i < 3'000; ++i) {
    const Solved problem = random_solved();
    const mpq_class rho(from_to(1, 16), 8);
    Numbers answer = problem.x;
    for (mpq_class& x : answer) x += rho * mpq_class(from_to(-4, 4), 4);
    const std::string header = problem.header(answer);
    CAPTURE(header);
    CHECK(verdict(header + " none-within" + listed({rho}) + " end").starts_with("rejected: every row"));
    CHECK(verdict(header + " eps 0" + listed({rho}) + " point" + listed(problem.x) + " motion" + listed(problem.w) +
                  " end")
              .starts_with("accepted: "));
    Numbers y(problem.x.size());
    for (std::size_t j = 0; j < y.size(); ++j) {
      if (j < problem.free) y[j] = from_to(-2, 2);
      if (j >= problem.free && (j - problem.free) % problem.dimension == 0) y[j] = from_to(0, 2);
    }
    CHECK(verdict(header + " no-solution multipliers" + listed(y) + " end").starts_with("rejected: "));
  }
}

TEST_CASE("an enclosure that is accepted has a solution in it") {
  int accepted = 0;
  for (int i = 0; i < 30'000; ++i) {
    Small problem{below(2) == 0, {}, {from_to(-4, 4), from_to(-4, 4)}};
    for (int row = 0; row < 2; ++row) problem.A.push_back({from_to(-3, 3), from_to(-3, 3)});
    bool complete = false;
    const auto solutions = problem.solutions(complete);
    if (!complete) continue;
    const std::string mode = !problem.planar || below(2) == 0 ? "stick" : below(2) == 0 ? "slide+" : "slide-";
    const auto [J, constants] = problem.equations(mode, "stick");
    const mpq_class det = J[0][0] * J[1][1] - J[0][1] * J[1][0];
    const mpq_class off(from_to(-1, 1), 4), rho(from_to(1, 8), 4);
    const std::vector<Numbers> R{{J[1][1] / det + off, -J[0][1] / det}, {-J[1][0] / det, J[0][0] / det}};
    Numbers center = solutions.empty() || below(4) == 0 ? Numbers{from_to(0, 8), from_to(-8, 8)} : solutions.back();
    for (mpq_class& z : center) z += mpq_class(from_to(-2, 2), 8);
    const Numbers answer{center[0] + mpq_class(from_to(-2, 2), 8), center[1]};
    const Numbers radius{mpq_class(from_to(1, 4), 4), mpq_class(from_to(1, 4), 4)};
    const std::string text = std::string("slipproof-contact 1 dimension ") +
                             (problem.planar ? "2 free 0 contacts 1 mu 1" : "1 free 0 contacts 2 mu 0 0") + " matrix " +
                             listed(problem.A) + " constant" + listed(problem.c) + " answer" + listed(answer) +
                             " enclosure" + listed({rho}) + " modes " + mode + (problem.planar ? "" : " stick") +
                             " center" + listed(center) + " radius" + listed(radius) + " pinned 0 dropped 0 inverse " +
                             listed(R) + " end";
    const std::string found = verdict(text);
    CAPTURE(text);
    CHECK(!found.starts_with("unreadable: "));
    if (!found.starts_with("accepted: ")) continue;
    ++accepted;
    bool near = false;
    for (const Numbers& x : solutions) near = near || (abs(x[0] - answer[0]) <= rho && abs(x[1] - answer[1]) <= rho);
    CHECK(near);
  }
  CHECK(accepted > 500);
}

TEST_CASE("where uniqueness with planar friction is accepted every constant leaves one solution") {
  const auto quarters = [](int low, int high) -> mpq_class { return mpq_class(from_to(low, high)) / 4; };
  int accepted = 0;
  for (int i = 0; i < 3'000; ++i) {
    Small problem{true, {}, {}};
    for (int row = 0; row < 2; ++row) problem.A.push_back({quarters(-8, 8), quarters(-8, 8)});
    for (std::size_t k = 0; k < 2; ++k) problem.A[k][k] += quarters(0, 16);
    const std::string text = "slipproof-contact 1 dimension 2 free 0 contacts 1 mu 1 matrix " + listed(problem.A) +
                             " constant 0 0 no-answer unique " + (i % 2 == 0 ? "determinants" : "bound") + " 3 0 0" +
                             listed({quarters(0, 4)}) + " 1 0" + listed({quarters(-4, 4)}) + " 1 1" +
                             listed({quarters(0, 4)}) + " end";
    CAPTURE(text);
    const std::string found = verdict(text);
    CHECK(!found.starts_with("unreadable: "));
    if (!found.starts_with("accepted: ")) continue;
    ++accepted;
    for (int k = 0; k < 10; ++k) {
      problem.c = {from_to(-6, 6), from_to(-6, 6)};
      bool complete = false;
      const auto solutions = problem.solutions(complete);
      REQUIRE(!solutions.empty());
      for (const Numbers& x : solutions) CHECK(x == solutions.front());  // the same one at a border of its mode
      CHECK(complete);
    }
  }
  CHECK(accepted > 100);
}
