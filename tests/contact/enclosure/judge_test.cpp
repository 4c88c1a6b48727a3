// Verdicts on problems that can be checked by hand.
#include "contact/judge/judge.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "contact/judge/find/find.hpp"

using namespace slipproof;

namespace {

/// One contact of a point of mass 1 in space, pressed on with the force -q_N and pulled along.
MixedProblem point_on_floor(std::vector<double> q, double mu) {
  MixedProblem p;
  p.A = from_dense(3, 3, std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1});
  p.c = std::move(q);
  p.mu = {mu};
  return p;
}

ContactJudgement judged(const MixedProblem& p, std::vector<double> x, ContactJudgeOptions options = {}) {
  return judge_contacts(p, std::move(x), {}, options);
}

}  // namespace

TEST_CASE("a point sticks, slides and leaves") {
  // Weight 10, pulled by (3, 4): friction 5 is enough with mu = 1, and slides with mu = 1/4 at an acceleration of 2.5.
  const auto sticks = judged(point_on_floor({-10, 3, 4}, 1), {10, -3, -4});
  CHECK(sticks.verdict == ContactVerdict::solution_within_rho);
  CHECK(sticks.residual->change == 0);
  CHECK(sticks.rho < 1e-200);
  const auto slides = judged(point_on_floor({-10, 3, 4}, 0.25), {10, -1.5, -2});
  CHECK(slides.verdict == ContactVerdict::solution_within_rho);
  CHECK(slides.rho < 1e-14);
  CHECK(slides.enclosure->system.mode().front() == ConeState::slide);
  const auto leaves = judged(point_on_floor({1, 3, 4}, 1), {0, 0, 0});
  CHECK(leaves.verdict == ContactVerdict::solution_within_rho);
}

TEST_CASE("solutions of many contacts are found and enclosed, side by side and in a chain") {
  // Points that are pressed, pulled or lifted, 7 in turn; in the chain each feels a tenth of its neighbours' forces.
  const std::size_t contacts = 12000;
  for (const double coupling : {0.0, 0.1}) {
    MixedProblem p;
    p.A.rows = p.A.columns = 3 * contacts;
    for (std::size_t i = 0; i < 3 * contacts; ++i) {
      const auto add = [&](std::size_t column, double value) {
        p.A.column.push_back(static_cast<std::uint32_t>(column)), p.A.value.push_back(value);
      };
      if (coupling > 0 && i >= 3) add(i - 3, coupling);
      add(i, 1);
      if (coupling > 0 && i + 3 < 3 * contacts) add(i + 3, coupling);
      p.A.starts.push_back(p.A.value.size());
    }
    for (std::size_t k = 0; k < contacts; ++k) {
      const double turn = static_cast<double>(k % 7);
      p.c.insert(p.c.end(), {turn - 4.5, 0.3 * turn, -0.2});
      p.mu.push_back(0.25);
    }
    const std::vector<double> start = approximate_solution(p);
    REQUIRE(start.size() == 3 * contacts);
    const auto found = judged(p, start);
    CHECK(is_certified(found.verdict));
    CHECK(found.rho < 1e-10);
  }
}

TEST_CASE("a sliding contact may open by rounding") {
  // Right but for the last digits: u = (2^-52, -3, -4), and r is inside of the cone by less than can be seen.
  const auto slides =
      judged(point_on_floor({-1 + 0x1p-52, -3.3, -4.4}, 0.5), {1, std::nextafter(0.3, 0), std::nextafter(0.4, 0)});
  CHECK(slides.residual->contacts.front().fit == ContactFit::slide);
  CHECK(slides.residual->backward_error() < 1e-15);
  CHECK(slides.verdict == ContactVerdict::solution_within_rho);
}

TEST_CASE("what is wrong is named, with a radius without solutions") {
  const auto found = judged(point_on_floor({-10, 3, 4}, 0.25), {10, -3, -4});
  CHECK(found.verdict == ContactVerdict::wrong);
  REQUIRE_FALSE(found.residual->worst.empty());
  CHECK(found.residual->worst.front().contact == 0);
  // |r_t| = 5 and mu r_n = 2.5: the nearest solution is at (10, -1.5, -2), 2 away.
  CHECK(found.exclusion->radius > 0.5);
  CHECK(found.exclusion->radius <= 2);
  ContactJudgeOptions within;
  within.within = 0.5;
  CHECK(judged(point_on_floor({-10, 3, 4}, 0.25), {10, -3, -4}, within).verdict == ContactVerdict::none_within_rho);
}

TEST_CASE("an answer that is right for the pyramid is told as that") {
  // Pulled along the diagonal with mu = 1/2: the box lets each direction have 5, the cone 5 in all, the diamond 5 in
  // sum.
  const MixedProblem p = point_on_floor({-10, 9, 9}, 0.5);
  const auto box = judged(p, {10, -5, -5});
  CHECK(box.verdict == ContactVerdict::wrong);
  CHECK(box.right_for == FrictionLaw::box);
  const auto diamond = judged(p, {10, -2.5, -2.5});
  CHECK(diamond.verdict == ContactVerdict::wrong);
  CHECK(diamond.right_for == FrictionLaw::diamond);
  const auto neither = judged(p, {10, -1, -1});
  CHECK(neither.verdict == ContactVerdict::wrong);
  CHECK_FALSE(neither.right_for);
  // At a corner of the diamond all directions between the normals of its edges are opposite to it.
  CHECK(judged(point_on_floor({-10, 9, 3}, 0.5), {10, -5, 0}).right_for == FrictionLaw::diamond);
  const auto right = judged(p, {10, -5 / std::sqrt(2.0), -5 / std::sqrt(2.0)});
  CHECK(right.verdict == ContactVerdict::solution_within_rho);
}

TEST_CASE("two solutions are shown") {
  // A rod like Painleve's: pushing makes friction press harder than it resists. It may leave, stick, or slide on.
  MixedProblem p;
  p.A = from_dense(3, 3, std::vector<double>{1, 2, 0, 2, 5, 0, 0, 0, 1});
  p.mu = {1};
  // Sliding: r = N (1, -1, 0), u_n = N - 2 N + q_n, zero for N = q_n = 1; u_t = 2 N - 5 N + q_t = 3 > 0 for q_t = 6.
  p.c = {1, 6, 0};
  const auto found = judged(p, {0, 0, 0});
  CHECK(found.verdict == ContactVerdict::ambiguous);
  CHECK(found.other_exact == std::vector<Rational>{7, -4, 0});  // sticking: 7 - 8 + 1 = 0 and 14 - 20 + 6 = 0
  CHECK(judged(p, {1, -1, 0}).verdict == ContactVerdict::ambiguous);
  // Beside a point that slides along (3, 4) no mode of both has linear equations.
  p.A = from_dense(6, 6, std::vector<double>{1, 2, 0, 0, 0, 0, 2, 5, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0,
                                             0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1});
  p.mu = {1, 0.25};
  p.c = {1, 6, 0, -10, 3, 4};
  const auto both = judged(p, {0, 0, 0, 10, -1.5, -2});
  CHECK(both.verdict == ContactVerdict::ambiguous);
  CHECK(both.other_exact.empty());
  REQUIRE(both.other);
  const auto other = center_of(*both.other);
  CHECK(std::abs(other[0] - 1) < 1e-12);
  CHECK(std::abs(other[1] + 1) < 1e-12);
}

TEST_CASE("a block on four corners: forces that nothing determines are pinned") {
  // Weight 4 on the corners (+-1, +-1) of a block of unit mass and inertias. W = J M^-1 J^T has rank 3 in the normals;
  // the tangential parts are kept apart, and let nothing slide.
  std::vector<double> W(144), corners(16);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const int xi = i % 2 == 0 ? 1 : -1, yi = i < 2 ? 1 : -1, xj = j % 2 == 0 ? 1 : -1, yj = j < 2 ? 1 : -1;
      const double w = 1 + xi * xj + yi * yj;
      W[static_cast<std::size_t>(36 * i + 3 * j)] = corners[static_cast<std::size_t>(4 * i + j)] = w;
    }
    for (const int t : {1, 2}) W[static_cast<std::size_t>(12 * (3 * i + t) + 3 * i + t)] = 1;
  }
  MixedProblem p;
  p.A = from_dense(12, 12, W);
  p.c = {-4, 0, 0, -4, 0, 0, -4, 0, 0, -4, 0, 0};
  p.mu = {1, 1, 1, 1};
  const std::vector<double> x{1.5, 0, 0, 0.5, 0, 0, 0.5, 0, 0, 1.5, 0, 0};
  const auto found = judged(p, x);
  CHECK(found.verdict == ContactVerdict::solution_within_rho);
  CHECK(found.rho < 1e-14);
  REQUIRE(found.enclosure);
  CHECK(found.enclosure->pinned.size() == 1);
  CHECK(found.enclosure->dropped.size() == 1);
  CHECK_FALSE(found.enclosure->locally_unique);
  // The same with a constant that the motion of one block cannot have: the equations contradict each other.
  p.c[0] = -4.5;
  CHECK(judged(p, x).verdict == ContactVerdict::wrong);
  // Of a complementarity problem x itself is asked for, and there are many.
  MixedProblem lcp;
  lcp.dimension = 1;
  lcp.A = from_dense(4, 4, corners);
  lcp.c = {-4, -4, -4, -4};
  lcp.mu = {0, 0, 0, 0};
  CHECK(judged(lcp, {1.5, 0.5, 0.5, 1.5}).verdict == ContactVerdict::ambiguous);
}

TEST_CASE("velocities that are not those of the forces are wrong") {
  const MixedProblem p = point_on_floor({-10, 3, 4}, 1);
  const std::vector<double> u{0, 0.5, 0};
  const auto found = judge_contacts(p, {10, -3, -4}, u, {});
  CHECK(found.verdict == ContactVerdict::wrong);
  CHECK(found.velocity_error == doctest::Approx(0.5));
}

TEST_CASE("a solution is found where no answer is given") {
  const MixedProblem p = point_on_floor({-10, 3, 4}, 0.25);
  const auto x = approximate_solution(p);
  REQUIRE(x.size() == 3);
  CHECK(judged(p, x).verdict == ContactVerdict::solution_within_rho);
}

TEST_CASE("problems with two solutions, or none, are never told to have one") {
  // Painleve's rod in space: W couples pulling and pressing, so that it may leave or slide on.
  int several = 0;
  for (int i = 1; i <= 40; ++i) {
    MixedProblem p;
    const double coupling = 1 + i / 8.0;
    p.A = from_dense(3, 3, std::vector<double>{1, coupling, 0, coupling, 2 * coupling * coupling, 0, 0, 0, 1});
    p.mu = {1};
    p.c = {1, 40 * coupling * coupling, 0};
    for (const std::vector<double>& x : {std::vector<double>{0, 0, 0}, std::vector<double>{1, -1, 0}}) {
      ContactJudgeOptions options;
      options.refine = true;
      const auto found = judged(p, x, options);
      CHECK(found.verdict != ContactVerdict::unique);
      several += found.verdict == ContactVerdict::ambiguous ? 1 : 0;
    }
  }
  CHECK(several >= 40);
  // Pressing pulls it in: u_n = -r_n - 1 is never >= 0.
  MixedProblem none;
  none.A = from_dense(3, 3, std::vector<double>{-1, 0, 0, 0, 1, 0, 0, 0, 1});
  none.mu = {1};
  none.c = {-1, 2, 0};
  for (const double N : {0.0, 1.0, -1.0}) CHECK(judged(none, {N, 0, 0}).verdict == ContactVerdict::no_solution);
}
