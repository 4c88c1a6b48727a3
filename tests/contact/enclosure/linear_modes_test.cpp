// Solutions in modes whose equations are linear, against a search through all of them by hand.
#include "contact/exact/linear_modes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/number/binary64.hpp"
#include "base/number/dice.hpp"
#include "contact/judge/judge.hpp"
#include "support/how_many.hpp"

using namespace slipproof;

namespace linear_modes_by_hand {

namespace {

using Vector = std::vector<Rational>;

MixedProblem problem_of(std::size_t dimension, const std::vector<double>& W, const std::vector<double>& q, double mu) {
  MixedProblem p;
  p.dimension = dimension;
  p.A = from_dense(q.size(), q.size(), W);
  p.c = q;
  p.mu.assign(q.size() / dimension, mu);
  return p;
}

Vector velocities(const MixedProblem& p, const Vector& r) {
  Vector u;
  for (std::size_t i = 0; i < p.size(); ++i) u.push_back(exact_row(p, i, r));
  return u;
}

/// The one solution of some rows of W r + q = 0 with the same components of r, the others being 0, by elimination;
/// nothing where there is not exactly one.
std::optional<Vector> forces_of(const MixedProblem& p, const std::vector<std::size_t>& closed) {
  const std::size_t n = closed.size();
  std::vector<Vector> rows;
  for (const std::size_t i : closed) {
    Vector all(p.size());
    for (std::size_t e = p.A.starts[i]; e < p.A.starts[i + 1]; ++e) all[p.A.column[e]] = to_rational(p.A.value[e]);
    Vector& row = rows.emplace_back();
    for (const std::size_t j : closed) row.push_back(all[j]);
    row.push_back(-to_rational(p.c[i]));
  }
  for (std::size_t k = 0; k < n; ++k) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(k), rows.end(),
                                    [k](const Vector& row) { return !row[k].is_zero(); });
    if (pivot == rows.end()) return std::nullopt;
    std::swap(rows[k], *pivot);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const Rational factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  Vector r(p.size());
  for (std::size_t k = 0; k < n; ++k) r[closed[k]] = rows[k][n] / rows[k][k];
  return r;
}

/// All solutions in which each contact is open or sticks; nothing where a mode has no one solution of its equations.
std::optional<std::set<Vector>> all_by_hand(const MixedProblem& p) {
  std::set<Vector> found;
  for (unsigned mode = 0; mode < 1U << p.contacts(); ++mode) {
    std::vector<std::size_t> closed;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if ((mode >> i / p.dimension & 1U) != 0) closed.push_back(i);
    }
    const auto r = forces_of(p, closed);
    if (!r) return std::nullopt;
    const Vector u = velocities(p, *r);
    bool right = true;
    for (std::size_t n = 0; n < p.size(); n += p.dimension) {
      Rational square = 0;
      for (std::size_t i = n + 1; i < n + p.dimension; ++i) square += (*r)[i] * (*r)[i];
      const Rational bound = to_rational(p.mu[n / p.dimension]) * (*r)[n];
      right = right && (*r)[n].sign() >= 0 && u[n].sign() >= 0 && square <= bound * bound;
    }
    if (right) found.insert(*r);
  }
  return found;
}

/// All solutions in modes in which contacts are open or stick; in the plane they slide, too. But for a known one's.
std::set<Vector> all_linear(const MixedProblem& p, const ConeMode* known = nullptr) {
  std::set<Vector> found;
  Effort effort(unlimited);
  each_linear_solution(p, eliminated(p)->problem, Slides::none, std::vector<double>(p.size(), 0), known, effort,
                       [&](const Vector& r) {
                         found.insert(r);
                         return true;
                       });
  return found;
}

/// By Coulomb's law as it is defined.
bool solves(const MixedProblem& p, const Vector& r) {
  if (r.size() != p.size()) return false;
  const Vector u = velocities(p, r);
  for (std::size_t n = 0; n < p.size(); n += 3) {
    const Rational bound = to_rational(p.mu[n / 3]) * r[n], square = r[n + 1] * r[n + 1] + r[n + 2] * r[n + 2];
    if (r[n].sign() < 0 || u[n].sign() < 0 || !(r[n] * u[n]).is_zero() || square > bound * bound) return false;
    if ((u[n + 1].is_zero() && u[n + 2].is_zero()) || bound.is_zero()) continue;
    const bool against =
        (r[n + 1] * u[n + 2] - r[n + 2] * u[n + 1]).is_zero() && (r[n + 1] * u[n + 1] + r[n + 2] * u[n + 2]).sign() < 0;
    if (!against || square != bound * bound) return false;
  }
  return true;
}

ContactJudgement judged(const MixedProblem& p, const Vector& r) {
  std::vector<double> x;
  for (const Rational& value : r) x.push_back(nearest_binary64(value));
  return judge_contacts(p, x, {}, {});
}

/// Positive definite, with much coupling: several solutions are frequent where mu is large.
MixedProblem random_problem(Dice& dice) {
  const auto contacts = static_cast<std::size_t>(dice.number(1, 3)), n = 3 * contacts;
  std::vector<std::vector<int>> J(n, std::vector<int>(n));
  for (auto& row : J) {
    for (int& a : row) a = dice.number(-2, 2);
  }
  std::vector<double> W(n * n, 0), q;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t a = 0; a < n; ++a) W[i * n + j] += J[i][a] * J[j][a];
    }
    W[i * n + i] += 1;
    q.push_back(i % 3 == 0 ? dice.number(-1, 3) : dice.number(-3, 3));
  }
  return problem_of(3, W, q, dice.number(2, 6));
}

}  // namespace

TEST_CASE("a contact that may stay open and may stick has two solutions, from either answer") {
  const MixedProblem p = problem_of(3, {9, -4, -4, -4, 7, 2, -4, 2, 3}, {2, -3, -3}, 3);
  const Vector none(3), sticks{Rational(2, 3), Rational(1, 3), Rational(5, 3)};
  ContactJudgement j = judged(p, none);
  CHECK(j.verdict == ContactVerdict::ambiguous);
  CHECK(j.other_exact == sticks);
  REQUIRE(j.linear_modes.has_value());
  CHECK(j.linear_modes->modes == 2);
  CHECK(j.linear_modes->tried);
  j = judged(p, sticks);
  CHECK(j.verdict == ContactVerdict::ambiguous);
  CHECK(j.other_exact == none);
}

TEST_CASE("a contact that may stay open and may slide along an axis has two solutions") {
  const MixedProblem p = problem_of(3, {6, 2, -2, 2, 9, -8, -2, -8, 9}, {0, 1, -2}, 3);
  const Vector slides{Rational(1, 22), 0, Rational(3, 22)};
  CHECK(velocities(p, slides) == Vector{0, 0, Rational(-19, 22)});
  const ContactJudgement j = judged(p, Vector(3));
  CHECK(j.verdict == ContactVerdict::ambiguous);
  CHECK(j.other_exact == slides);
}

TEST_CASE("one answer of several known solutions is never told without another") {
  std::map<std::size_t, int> seen;
  const auto problems = test::how_many<std::uint64_t>("SLIPPROOF_SEVERAL_SOLUTIONS", test::quick(1500, 200));
  for (std::uint64_t i = 0; i < problems; ++i) {
    CAPTURE(i);
    Dice dice(6111, i);
    const MixedProblem p = random_problem(dice);
    const auto all = all_by_hand(p);
    REQUIRE(all.has_value());
    ++seen[all->size()];
    if (all->size() < 2) continue;
    for (const Vector& r : *all) {
      const ContactJudgement j = judged(p, r);
      CHECK(j.verdict == ContactVerdict::ambiguous);
      CHECK(j.other_exact != r);
      CHECK(solves(p, j.other_exact));
    }
  }
  CHECK(seen[2] > 0);
  CHECK(seen[3] + seen[4] + seen[5] + seen[6] + seen[7] > 0);
}

TEST_CASE("linear modes give the solutions that a search by hand gives, and no others") {
  for (std::uint64_t i = 0; i < 300; ++i) {
    CAPTURE(i);
    Dice dice(6112, i);
    const MixedProblem p = random_problem(dice);
    CHECK(all_linear(p) == all_by_hand(p));
  }
}

TEST_CASE("in the plane contacts slide in linear modes, and without friction they are closed") {
  // A block that is pulled: N = 1, T = -1/2, slip = 1/4.
  const MixedProblem block = problem_of(2, {1, 0, 0, 1}, {-1, 0.75}, 0.5);
  CHECK(linear_modes(block, Slides::none) == 4);
  CHECK(linear_modes(problem_of(2, {1, 0, 0, 1}, {-1, 0.75}, 0), Slides::none) == 2);
  CHECK(linear_modes(problem_of(1, {1, 0, 0, 1}, {-1, 1}, 0), Slides::none) == 4);
  const std::set<Vector> slides{{1, Rational(-1, 2)}};
  CHECK(all_linear(block) == slides);
  const ConeMode plus{ConeState::slide_plus}, minus{ConeState::slide_minus};
  CHECK(all_linear(block, &minus) == slides);
  CHECK(all_linear(block, &plus).empty());
}

TEST_CASE("a force at the edge of its cone sticks, although rounding cannot tell") {
  const MixedProblem block = problem_of(3, {3, 0, 0, 0, 3, 0, 0, 0, 3}, {-1, 0.5, 0}, 0.5);
  CHECK(all_linear(block) == std::set<Vector>{{Rational(1, 3), Rational(-1, 6), 0}});
  const MixedProblem beyond = problem_of(3, {3, 0, 0, 0, 3, 0, 0, 0, 3}, {-1, 0.5 + 0x1p-50, 0}, 0.5);
  CHECK(all_linear(beyond).empty());
}

TEST_CASE("forces that a mode leaves open do not make one motion two") {
  // Two contacts at one place: any r_1 + r_2 = 1.
  const MixedProblem twice = problem_of(
      3, {1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1},
      {-1, 0, 0, -1, 0, 0}, 0.5);
  const ContactJudgement j = judged(twice, {Rational(1, 4), 0, 0, Rational(3, 4), 0, 0});
  CHECK(j.verdict == ContactVerdict::solution_within_rho);
  CHECK(j.undetermined == 3);
  CHECK_FALSE(j.others_excluded());
}

TEST_CASE("more modes than the effort allows are not tried, which is told") {
  std::vector<double> W(90 * 90, 0), q;
  for (std::size_t i = 0; i < 90; ++i) {
    W[i * 90 + i] = 1;
    q.push_back(i % 3 == 0 ? -1 : 0);
  }
  Vector r(90);
  for (std::size_t i = 0; i < 90; i += 3) r[i] = 1;
  const ContactJudgement j = judged(problem_of(3, W, q, 0.5), r);
  CHECK(j.verdict == ContactVerdict::solution_within_rho);
  REQUIRE(j.linear_modes.has_value());
  CHECK(j.linear_modes->modes == Work{1} << 30U);
  CHECK_FALSE(j.linear_modes->tried);
}

TEST_CASE("an effort above the usual one tries modes that are left out by default") {
  const std::size_t n = 27;
  std::vector<double> W(n * n, 0), q, r;
  for (std::size_t i = 0; i < n; ++i) {
    W[i * n + i] = 1;
    q.push_back(i % 3 == 0 ? -1 : 0);
    r.push_back(i % 3 == 0 ? 1 : 0);
  }
  const MixedProblem p = problem_of(3, W, q, 0.5);
  ContactJudgeOptions options;
  CHECK_FALSE(judge_contacts(p, r, {}, options).linear_modes->tried);
  options.effort = 5 * ContactJudgeOptions::usual_effort;
  CHECK(judge_contacts(p, r, {}, options).linear_modes->tried);
}

}  // namespace linear_modes_by_hand
