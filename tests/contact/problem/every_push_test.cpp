// Redundant contacts under every push: against all solutions, by the kernel, under pushes at random and those told.
#include "contact/problem/every_push.hpp"

#include <doctest/doctest.h>

#include <set>

#include "contact/problem/solutions.hpp"
#include "support/scenes/random_scene.hpp"

using namespace slipproof;
using Verdict = EveryLoad::Verdict;

namespace {

/// Contacts of a body with fewer directions to move in than contacts push: W = B B^T, q = B f.
struct Redundant {
  RationalMatrix B;
  ContactProblem problem;

  Redundant(RationalMatrix directions, std::vector<Rational> mu) : B(std::move(directions)) {
    problem.mu = std::move(mu);
    for (const auto& row : B) {
      problem.W.emplace_back();
      for (const auto& other : B) problem.W.back().push_back(dot(row, other));
    }
    problem.q.assign(B.size(), 0);
  }
  static Rational dot(const std::vector<Rational>& x, const std::vector<Rational>& y) {
    Rational sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
    return sum;
  }
  void push(const std::vector<Rational>& f) {
    for (std::size_t i = 0; i < B.size(); ++i) problem.q[i] = dot(B[i], f);
  }
};

/// Two feet at x = -1 and x = b of a body of mass 1 and radius of inertia 1, at height h: accelerations (gap, slip) of
/// each, over (ax, ay, alpha).
Redundant two_feet(const Rational& b, const Rational& h, const Rational& mu) {
  return {{{0, 1, -1}, {1, 0, h}, {0, 1, b}, {1, 0, h}}, {mu, mu}};
}

/// The different w of all solutions; 2 where there are infinitely many.
std::size_t motions(const ContactProblem& problem) {
  const auto all = ContactSolver(problem).all();
  REQUIRE(all);
  std::set<std::vector<Rational>> found;
  for (const ContactSolution& solution : all->solutions) found.insert(solution.w);
  for (const ContactContinuum& continuum : all->continua) {
    found.insert(accelerations(problem, continuum.base));
    for (const auto& direction : continuum.directions) {
      std::vector<Rational> z = continuum.base;
      for (std::size_t i = 0; i < z.size(); ++i) z[i] += direction[i];
      found.insert(accelerations(problem, z));
    }
  }
  return found.size();
}

}  // namespace

TEST_CASE("two level feet have one motion whatever pushes, up to a coefficient of friction known by hand") {
  // Slip as a whole with both pressed, S = -mu (N1 + N2): the feet's slip turns N by h alone; on one foot at x = -1
  // Painleve's condition is mu h x < 1 + x^2 = 2.
  CHECK(for_every_push(two_feet(1, 1, Rational(19, 10)).problem).verdict == Verdict::at_most_one);
  const EveryLoad beyond = for_every_push(two_feet(1, 1, Rational(21, 10)).problem);
  CHECK(beyond.verdict == Verdict::not_unique);
  CHECK(beyond.undetermined == 1);
}

TEST_CASE("under the push that is told both modes are motions with different accelerations") {
  Redundant feet = two_feet(2, 3, 4);
  const EveryLoad found = for_every_push(feet.problem);
  REQUIRE(found.verdict == Verdict::not_unique);
  feet.problem.q = found.q;
  CHECK(motions(feet.problem) > 1);
  for (const auto& mode : {found.mode, found.other}) {
    Effort effort(ContactSolver::default_effort);
    const auto kind = ContactSolver(feet.problem).solve(*mode, effort).kind;
    const bool is_solution = kind == ModeOutcome::Kind::solution || kind == ModeOutcome::Kind::continuum;
    CHECK(is_solution);
  }
}

TEST_CASE("what is said of every push holds under pushes at random") {
  test::RandomScenes random(38);
  std::size_t unique = 0, several = 0;
  for (int round = 0; round < 40; ++round) {
    const auto number = [&] { return Rational(random.integer(-3, 3)); };
    RationalMatrix B;
    for (int i = 0; i < 4; ++i) B.push_back({number(), number(), number()});
    Redundant bodies(B, {random.fraction(0, 8), random.fraction(0, 8)});
    const EveryLoad found = for_every_push(bodies.problem);
    if (found.verdict == Verdict::not_unique && found.other) {
      bodies.problem.q = found.q;
      CHECK(motions(bodies.problem) > 1);
      ++several;
    }
    if (found.verdict != Verdict::at_most_one) continue;
    ++unique;
    for (int pushed = 0; pushed < 10; ++pushed) {
      bodies.push({number(), number(), number()});
      CHECK(motions(bodies.problem) <= 1);
    }
  }
  CHECK(unique >= 5);
  CHECK(several >= 5);
}

TEST_CASE("without friction redundant contacts always have unique accelerations") {
  Redundant three({{1, 1}, {1, 0}, {1, -1}}, {});
  const EveryLoad found = for_every_push(three.problem);
  CHECK(found.verdict == Verdict::at_most_one);
  CHECK(found.undetermined == 1);
}

TEST_CASE("nothing is said where the problem's own q is not one that pushes make") {
  Redundant feet = two_feet(1, 1, 1);
  feet.problem.q = {0, 1, 0, 0};  // one foot slides away from the other
  CHECK(for_every_push(feet.problem).reason == EveryLoad::Reason::no_theorem);
}

TEST_CASE("too many pairs of modes are undecided, with what is undetermined") {
  Redundant feet = two_feet(1, 1, 1);
  const EveryLoad found = for_every_push(feet.problem, 100);
  CHECK(found.verdict == Verdict::undecided);
  CHECK(found.undetermined == 1);
}
