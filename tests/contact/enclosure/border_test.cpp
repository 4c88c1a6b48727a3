// Contacts that touch without load, or are at the edge of their cones: solutions that no interval can prove.
#include "contact/exact/border.hpp"

#include <doctest/doctest.h>

#include "base/number/binary64.hpp"
#include "base/number/dice.hpp"
#include "contact/judge/judge.hpp"

using namespace slipproof;

namespace border {

namespace {

MixedProblem problem_of(std::size_t dimension, const std::vector<double>& W, std::vector<double> q, double mu) {
  MixedProblem p;
  p.dimension = dimension;
  p.A = from_dense(q.size(), q.size(), W);
  p.mu.assign(q.size() / dimension, mu);
  p.c = std::move(q);
  return p;
}

/// Two contacts with W = [[2, 1], [1, 2]] in each direction.
MixedProblem two_coupled(std::vector<double> q, double mu) {
  std::vector<double> W(36);
  for (std::size_t i = 0; i < 6; ++i) {
    W[i * 6 + i] = 2;
    W[i * 6 + (i + 3) % 6] = 1;
  }
  return problem_of(3, W, std::move(q), mu);
}

ContactJudgement judged(const MixedProblem& p, std::vector<double> x) {
  return judge_contacts(p, std::move(x), {}, {});
}

/// A matrix with integers that its diagonal dominates, and q for which r moves nothing.
MixedProblem at_rest(Dice& dice, std::size_t dimension, const std::vector<double>& r, double mu) {
  const std::size_t n = r.size();
  std::vector<double> W(n * n), q(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) W[i * n + j] = W[j * n + i] = dice.chance(4) ? dice.number(-3, 3) : 0;
  }
  for (std::size_t i = 0; i < n; ++i) {
    W[i * n + i] = static_cast<double>(3 * n);
    for (std::size_t j = 0; j < n; ++j) q[i] -= W[i * n + j] * r[j];
  }
  return problem_of(dimension, W, q, mu);
}

}  // namespace

TEST_CASE("a contact that touches without load is no obstacle") {
  // The first contact sticks with 1, which just keeps the second from closing.
  const MixedProblem p = two_coupled({-2, 0, 0, -1, 0, 0}, 0.5);
  const auto found = judged(p, {1, 0, 0, 0, 0, 0});
  CHECK(found.verdict == ContactVerdict::solution_within_rho);
  CHECK(found.rho == 0);
  CHECK(found.exact == std::vector<Rational>{1, 0, 0, 0, 0, 0});
  CHECK(judged(p, {1 + 1e-9, 0, 0, 1e-9, 0, 0}).rho <= 1.1e-9);
  CHECK(judged(p, {1.5, 0, 0, 0, 0, 0}).verdict == ContactVerdict::wrong);
}

TEST_CASE("three contacts stick and 41 touch without load") {
  Dice dice(16, 0);
  std::vector<double> r(3 * 44);
  for (const std::size_t k : {4U, 17U, 30U}) {
    r[3 * k] = dice.number(3, 9);
    r[3 * k + 1] = 1;
  }
  const auto found = judged(at_rest(dice, 3, r, 0.5), r);
  CHECK(found.verdict == ContactVerdict::solution_within_rho);
  REQUIRE(found.exact.size() == r.size());
  for (std::size_t i = 0; i < r.size(); ++i) CHECK(found.exact[i] == to_rational(r[i]));
}

TEST_CASE("beside a contact that slides in space another one may touch without load") {
  // As above, but pushed: the first contact slides along (3, 4) / 5, the second one, just at the floor, along with it.
  const MixedProblem p = two_coupled({-2, 3, 4, -1, 3, 4}, 0.25);
  const auto found = judged(p, {1, -0.15, -0.2, 0, 0, 0});
  REQUIRE(found.verdict == ContactVerdict::solution_within_rho);
  CHECK(found.rho < 1e-14);
  CHECK(found.undetermined == 0);
  REQUIRE(found.enclosure.has_value());
  CHECK(found.enclosure->system.mode() == ConeMode{ConeState::slide, ConeState::touch});
  CHECK(!found.enclosure->locally_unique);
  // With another last bit in its constant it leaves the floor, or presses: it does not touch without load.
  for (const double c : {-1 - 0x1p-52, -1 + 0x1p-53}) {
    MixedProblem q = p;
    q.c[3] = c;
    const auto other = judged(q, {1, -0.15, -0.2, 0, 0, 0});
    CHECK((!other.enclosure || other.enclosure->system.mode()[1] != ConeState::touch));
  }
}

TEST_CASE("at the edge of its cone a contact may stick or be about to slide") {
  Dice dice(16, 1);
  // In the plane every mode is linear, in space the modes without sliding: (3, 4) is at the edge for N = 10, mu = 1/2.
  const auto plane = judged(at_rest(dice, 2, {8, 4, 6, -3, 0, 0, 0, 0, 9, 1, 0, 0, 4, 1, 6, 3}, 0.5),
                            {8, 4, 6, -3, 0, 0, 0, 0, 9, 1, 0, 0, 4, 1, 6, 3});
  CHECK(plane.rho == 0);
  CHECK((plane.verdict == ContactVerdict::unique || plane.verdict == ContactVerdict::solution_within_rho));
  const std::vector<double> r{10, 3, 4, 0, 0, 0, 7, 1, 1};
  const auto space = judged(at_rest(dice, 3, r, 0.5), r);
  CHECK(space.verdict == ContactVerdict::solution_within_rho);
  CHECK(space.rho == 0);
}

TEST_CASE("forces that nothing determines are held where the border is solved") {
  // Two contacts share a load of 2, a third one touches: W has rank 1 in the loaded ones.
  std::vector<double> W(81);
  for (std::size_t i = 0; i < 3; ++i) {
    for (const std::size_t j : {i, i + 3}) W[i * 9 + j] = W[(i + 3) * 9 + j] = 1;
    W[(i + 6) * 9 + i + 6] = 1;
    W[i * 9 + i + 6] = W[(i + 6) * 9 + i] = W[(i + 3) * 9 + i + 6] = W[(i + 6) * 9 + i + 3] = 0.5;
  }
  const MixedProblem p = problem_of(3, W, {-2, 0, 0, -2, 0, 0, -1, 0, 0}, 1);
  const auto found = judged(p, {1.5, 0, 0, 0.5, 0, 0, 0, 0, 0});
  CHECK(found.verdict == ContactVerdict::solution_within_rho);
  CHECK(found.rho == 0);
  CHECK(found.undetermined == 3);
}

TEST_CASE("what is found at a border obeys the law exactly") {
  int solved = 0;
  for (std::uint64_t i = 0; i < 60; ++i) {
    Dice dice(17, i);
    const std::size_t dimension = dice.chance(2) ? 2 : 3, contacts = static_cast<std::size_t>(dice.number(1, 4));
    std::vector<double> r(dimension * contacts);
    for (std::size_t k = 0; k < contacts; ++k) {
      if (dice.chance(2)) continue;
      r[dimension * k] = dice.number(2, 5);
      r[dimension * k + 1] = dice.chance(2) ? r[dimension * k] / 2 : 0;
    }
    MixedProblem p = at_rest(dice, dimension, r, 0.5);
    for (std::size_t k = 0; k < contacts; ++k) {
      if (dice.chance(3)) p.c[dimension * k] += dice.number(-2, 2);
    }
    Effort effort(1'000'000'000);
    const auto found = solve_at_border(p, r, effort);
    if (!found) continue;
    ++solved;
    const std::vector<Rational>* x = &found->x;
    for (std::size_t k = 0; k < contacts; ++k) {
      const std::size_t n = dimension * k;
      const Rational& N = (*x)[n];
      const Rational gap = exact_row(p, n, *x);
      Rational squares = 0, slip = 0;
      for (std::size_t t = n + 1; t < n + dimension; ++t) {
        const Rational u = exact_row(p, t, *x);
        squares += (*x)[t] * (*x)[t];
        slip += u * u;
        CHECK((*x)[t] * u <= Rational(0));
      }
      CHECK(N >= Rational(0));
      CHECK(gap >= Rational(0));
      CHECK((N * gap).is_zero());
      CHECK(squares <= N * N / 4);
      if (!slip.is_zero()) CHECK(squares == N * N / 4);
    }
  }
  CHECK(solved > 20);
}

}  // namespace border
