// One solution for every q: against closed forms of the bicycle's thresholds, and against all solutions for given q.
#include "contact/problem/every_load.hpp"

#include <doctest/doctest.h>

#include <array>

#include "contact/problem/solutions.hpp"
#include "mechanics/kernel/mode_solver.hpp"
#include "support/bicycle/motions.hpp"
#include "support/scenes/bicycle_scenes.hpp"
#include "support/scenes/random_scene.hpp"

using namespace slipproof;

namespace {

/// The least coefficient at which a mode determinant of the bicycle vanishes, as it is worked out by hand.
Rational critical_coefficient(const Bicycle<Rational>& p) {
  const Rational mu = p.r2 / p.r1, I0 = mu * mu * p.I1 + p.I2, lever = p.R * (p.I2 + mu * p.I1) / I0;
  const Rational m0 = I0 / (p.R * p.R), m3 = p.I3 / (p.R * p.R), w = p.b2 + p.b3, h2 = p.h + p.R - lever;
  const Rational J = *p.J + (1 - mu) * (1 - mu) * p.I1 * p.I2 / I0;
  const std::array<std::array<Rational, 2>, 6> quotients{{{w * (p.M + m0), p.M * p.h + m0 * (lever - p.R)},
                                                          {w * (p.M + m3), p.M * h2 - m3 * (lever - p.R)},
                                                          {w, p.h + h2},
                                                          {w, p.h - h2},
                                                          {J + p.M * p.b2 * p.b2, p.M * p.b2 * h2},
                                                          {J + p.M * p.b3 * p.b3, p.M * p.b3 * p.h}}};
  Rational least = 0;  // none
  for (const auto& [numerator, denominator] : quotients) {
    if (denominator.is_zero()) continue;
    const Rational quotient = numerator / abs(denominator);
    if (least.is_zero() || quotient < least) least = quotient;
  }
  return least;
}

ContactProblem random_problem(test::RandomScenes& random, int contacts, bool frictional, bool skew = false) {
  ContactProblem problem;
  const auto n = static_cast<std::size_t>(frictional ? 2 * contacts : contacts);
  RationalMatrix A(n, std::vector<Rational>(n));
  for (auto& row : A) {
    for (Rational& x : row) x = random.integer(-3, 3);
  }
  problem.W.assign(n, std::vector<Rational>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = 0; k < n; ++k) problem.W[i][j] += A[i][k] * A[j][k];
    }
    problem.W[i][i] += Rational(1, 2);
  }
  for (std::size_t i = 1; skew && i < n; ++i) {  // the symmetric part stays
    problem.W[i][i - 1] += 2, problem.W[i - 1][i] -= 2;
  }
  if (!frictional) problem.W = A;  // of any sign
  for (int i = 0; frictional && i < contacts; ++i) {
    problem.mu.push_back(random.integer(0, 9) == 0 ? Rational(0) : random.fraction(0, 20));
  }
  problem.q.assign(n, 0);
  return problem;
}

/// A q that a point strictly inside of a mode's cone solves.
void put_inside(ContactProblem& problem, const ProblemMode& mode) {
  const std::size_t n = problem.size();
  std::vector<Rational> z(n), w(n);
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const std::size_t normal = problem.frictional() ? 2 * i : i;
    if (mode[i] == ElementState::lift) {
      w[normal] = 1;
      continue;
    }
    z[normal] = 1;
    const int direction = slip_direction(mode[i]);
    if (direction == 0) continue;
    z[normal + 1] = -problem.mu[i] * direction;
    w[normal + 1] = direction;
  }
  problem.q.assign(n, 0);
  const std::vector<Rational> forced = accelerations(problem, z);
  for (std::size_t i = 0; i < n; ++i) problem.q[i] = w[i] - forced[i];
}

}  // namespace

TEST_CASE("a bicycle's contact matrix is symmetric, and gives the accelerations of every motion") {
  test::RandomScenes random(211);
  for (int i = 0; i < 40; ++i) {
    const auto p = random.bicycle(true);
    const auto road = random.road();
    const ForceKind kind = i % 2 == 0 ? ForceKind::internal : ForceKind::external;
    const Rational F = random.any();
    const ContactProblem contacts = test::contacts_of(p, road, kind, F);
    CHECK(contacts.mu == std::vector<Rational>{road.f, road.f});
    for (std::size_t r = 0; r < 4; ++r) {
      CHECK(contacts.W[r][r] > 0);
      // slip is the acceleration along x, S the force along x; gap points up, N acts up: both pairs do work.
      for (std::size_t c = 0; c < r; ++c) CHECK(contacts.W[r][c] == contacts.W[c][r]);
    }
    const ModeTable table(p, road, kind);
    for (const ModeSolution& s : table.solutions()) {
      if (s.kind() != ModeSolution::Kind::regular) continue;
      const auto at = [&](Quantity q) { return s.quantity(q).at(F); };
      CHECK(accelerations(contacts, {at(Quantity::N2), at(Quantity::S2), at(Quantity::N3), at(Quantity::S3)}) ==
            std::vector<Rational>{at(Quantity::gap2), at(Quantity::slip2), at(Quantity::gap3), at(Quantity::slip3)});
    }
  }
}

TEST_CASE("contacts that cannot all open, or a wheel without inertia, make no contact problem") {
  test::RandomScenes random(212);
  auto p = random.bicycle(true);
  const auto none = [&](const Bicycle<Rational>& bicycle) {
    const MechanismScene scene = test::scene_of(bicycle, random.road(), ForceKind::internal);
    return !contact_problem(without_equations(friction_problem(scene.mechanism, scene.values)));
  };
  CHECK_FALSE(none(p));
  p.I3 = 0;
  CHECK(none(p));
  CHECK(none(random.bicycle(false)));
}

TEST_CASE("the bicycle's critical coefficient is the one worked out by hand") {
  test::RandomScenes random(223);
  for (int i = 0; i < 200; ++i) {
    const auto p = random.bicycle(true);
    const Rational f = critical_coefficient(p);
    if (f.is_zero()) continue;
    const auto verdict = [&](const Rational& factor) {
      return for_every_load(test::contacts_of(p, {f * factor, 1}, ForceKind::internal, 0)).verdict;
    };
    CHECK(verdict(Rational(999'999, 1'000'000)) == EveryLoad::Verdict::unique);
    CHECK(verdict(1) == EveryLoad::Verdict::not_unique);
    CHECK(verdict(Rational(1'000'001, 1'000'000)) == EveryLoad::Verdict::not_unique);
  }
}

TEST_CASE("one solution for every q, or a q with several, as all modes tell") {
  test::RandomScenes random(227);
  int unique = 0, several = 0;
  for (int i = 0; i < 150; ++i) {
    const bool frictional = i % 3 != 0;
    ContactProblem problem = random_problem(random, 2, frictional, i % 5 == 0);
    const EveryLoad found = for_every_load(problem);
    REQUIRE(found.verdict != EveryLoad::Verdict::undecided);
    CHECK((found.verdict == EveryLoad::Verdict::unique || !is_unique_by_bound(problem)));
    if (found.verdict == EveryLoad::Verdict::not_unique) {
      CHECK(found.determinant == mode_determinant(problem, *found.mode));
      put_inside(problem, *found.mode);
      bool one = ContactSolver(problem).all()->one();
      // With friction there are others there; in an LCP somewhere.
      for (int k = 0; !frictional && one && k < 200; ++k) {
        for (Rational& x : problem.q) x = random.integer(-3, 3);
        one = ContactSolver(problem).all()->one();
      }
      CHECK_FALSE(one);
      ++several;
      continue;
    }
    ++unique;
    for (int k = 0; k < 5; ++k) {
      for (Rational& x : problem.q) x = random.integer(-2, 2);
      CHECK(ContactSolver(problem).all()->one());
    }
  }
  CHECK(unique > 20);
  CHECK(several > 20);
}

TEST_CASE("beyond all modes the bound on mu decides, or nothing does") {
  test::RandomScenes random(229);
  ContactProblem problem = random_problem(random, 14, true);
  for (Rational& mu : problem.mu) mu = Rational(1, 10'000);
  EveryLoad found = for_every_load(problem);
  CHECK(found.verdict == EveryLoad::Verdict::unique);
  CHECK(found.reason == EveryLoad::Reason::bound);
  problem.mu.front() = 100;
  CHECK(for_every_load(problem).verdict == EveryLoad::Verdict::undecided);
  problem.W[0][0] = -1;
  CHECK(for_every_load(problem).reason == EveryLoad::Reason::no_theorem);
}

TEST_CASE("the bound on mu, at its edge") {
  // One contact, W = [1 c + k; c - k 1]: the bound asks for 1 - mu^2 - 2 mu |k| > c^2.
  const auto bound = [](const Rational& c, const Rational& k, const Rational& mu) {
    return is_unique_by_bound({{{1, c + k}, {c - k, 1}}, {0, 0}, {mu}});
  };
  const Rational little(1, 1000);
  CHECK(bound(Rational(3, 5), 0, Rational(4, 5) - little));
  CHECK_FALSE(bound(Rational(3, 5), 0, Rational(4, 5)));
  for (const int sign : {1, -1}) {  // 1 - 9/25 - 3/10 = 34/100
    CHECK(bound(Rational(58, 100), Rational(sign, 4), Rational(3, 5)));
    CHECK_FALSE(bound(Rational(59, 100), Rational(sign, 4), Rational(3, 5)));
  }
}

TEST_CASE("where the bound on mu holds all mode determinants are positive, W symmetric or not") {
  test::RandomScenes random(233);
  int held = 0;
  for (int i = 0; i < 300; ++i) {
    ContactProblem problem = random_problem(random, 2, true);
    for (std::size_t r = 0; r < 4; ++r) {
      problem.W[r][r] += random.fraction(0, 20);
      for (std::size_t s = 0; i % 3 != 0 && s < r; ++s) {
        const Rational skew = random.fraction(-8, 8);
        problem.W[r][s] += skew, problem.W[s][r] -= skew;
      }
    }
    for (Rational& mu : problem.mu) mu /= 4;
    if (!is_unique_by_bound(problem)) continue;
    ++held;
    CHECK(for_every_load(problem).verdict == EveryLoad::Verdict::unique);
  }
  CHECK(held > 50);
}

TEST_CASE("a contact without friction has no determinant for stick") {
  // T1 acts on N2 and T2, but is 0: what is left is the identity.
  const Rational half(1, 2);
  ContactProblem problem{{{1, 0, 0, 0}, {0, 1, half, half}, {0, half, 1, 0}, {0, half, 0, 1}}, {0, 0, 0, 0}, {0, 4}};
  CHECK(for_every_load(problem).verdict == EveryLoad::Verdict::unique);
  problem.mu = {1, 4};
  CHECK(for_every_load(problem).verdict == EveryLoad::Verdict::not_unique);
}
