// Ranges of forces that velocities leave open, against closed forms and against exact linear programs.
#include "contact/ranges/open_forces.hpp"

#include <doctest/doctest.h>

#include "base/algebra/linear_program.hpp"
#include "base/number/binary64.hpp"
#include "base/number/dice.hpp"
#include "contact/judge/judge.hpp"

using namespace slipproof;

namespace {

/// What bodies of mass and inertia 1 move at each component of the contacts.
using Jacobian = std::vector<std::vector<double>>;

MixedProblem problem_of(const Jacobian& H, std::size_t dimension, double mu) {
  const std::size_t n = H.size();
  std::vector<double> W(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t a = 0; a < H[i].size(); ++a) W[i * n + j] += H[i][a] * H[j][a];
    }
  }
  MixedProblem p;
  p.dimension = dimension;
  p.A = from_dense(n, n, W);
  p.c.assign(n, 0);
  p.mu.assign(n / dimension, mu);
  return p;
}

/// Gives it the constants with which x has these velocities.
MixedProblem with_solution(MixedProblem p, std::span<const double> x, std::span<const double> u) {
  const std::vector<Rational> w = exact_rows(p, x);
  for (std::size_t i = 0; i < p.size(); ++i) p.c[i] = u[i] - nearest_binary64(w[i]);
  return p;
}

/// A foot in space at (x, y), `below` the centre of mass.
void add_foot(Jacobian& H, double x, double y, double below) {
  H.push_back({0, 0, 1, y, -x, 0});
  H.push_back({1, 0, 0, 0, -below, -y});
  H.push_back({0, 1, 0, below, 0, x});
}

std::optional<OpenForces> ranges(const MixedProblem& p, std::span<const double> x, double tolerance = 1e-9) {
  Effort effort(unlimited);
  return open_forces(p, x, tolerance, effort);
}

const NormalRange& of_contact(const OpenForces& open, std::size_t contact) {
  const auto found = std::ranges::find(open.ranges, contact, &NormalRange::contact);
  REQUIRE(found != open.ranges.end());
  return *found;
}

/// The bounds hold, and are those of the closed form up to a millionth.
void check_range(const OpenForces& open, std::size_t contact, double least, double most) {
  CAPTURE(contact);
  const NormalRange& range = of_contact(open, contact);
  CHECK(range.least <= least);
  CHECK(range.least > least - 1e-6);
  REQUIRE(range.most.has_value());
  CHECK(*range.most >= most);
  CHECK(*range.most < most + 1e-6);
}

const std::vector<double> beam_at_rest{0.25, 0.5, 0.25}, no_motion(3, 0.0);

MixedProblem beam_on_three_feet() {
  return with_solution(problem_of({{1, -1}, {1, 0}, {1, 1}}, 1, 0), beam_at_rest, no_motion);
}

}  // namespace

TEST_CASE("a beam on three feet carries 0 to 1/2 at its ends and 0 to 1 in the middle") {
  const auto open = ranges(beam_on_three_feet(), beam_at_rest);
  REQUIRE(open.has_value());
  CHECK(open->directions == 1);
  CHECK(open->all);
  CHECK(open->change == 1e-9);
  check_range(*open, 0, 0, 0.5);
  check_range(*open, 1, 0, 1);
  check_range(*open, 2, 0, 0.5);
}

TEST_CASE("the same beam with its body as free unknowns has the same ranges") {
  MixedProblem p;
  p.free = 2;
  p.dimension = 1;
  p.A = from_dense(5, 5,
                   std::vector<double>{1, 0, -1, -1, -1, 0, 1, 1, 0, -1, 1, -1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0});
  p.c = {2, 0, 1, 1, 1};  // the floor goes down, the beam with it
  p.mu.assign(3, 0);
  const std::vector<double> x{-1, 0, 0.25, 0.5, 0.25};
  const auto open = ranges(p, x);
  REQUIRE(open.has_value());
  CHECK(open->directions == 1);
  check_range(*open, 0, 0, 0.5);
  check_range(*open, 1, 0, 1);
}

TEST_CASE("a box on four corners: six directions at rest, one while it slides") {
  Jacobian H;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) add_foot(H, x, y, 0.5);
  }
  SUBCASE("at rest each corner carries 0 to 1/2 of the weight") {
    const std::vector<double> x{1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0}, u(12, 0.0);
    const auto open = ranges(with_solution(problem_of(H, 3, 0.5), x, u), x);
    REQUIRE(open.has_value());
    CHECK(open->directions == 6);
    for (std::size_t k = 0; k < 4; ++k) check_range(*open, k, 0, 2);
  }
  SUBCASE("sliding along x, pairs of corners share what the motion gives them") {
    const std::vector<double> x{1, -0.5, 0, 1, -0.5, 0, 2, -1, 0, 2, -1, 0};
    std::vector<double> u(12, 0.0);
    for (const FrictionLaw law : {FrictionLaw::cone, FrictionLaw::associated}) {
      for (const std::size_t i : {1U, 4U, 7U, 10U}) {
        u[i] = 1;
        u[i - 1] = law == FrictionLaw::associated ? 0.5 : 0;  // there it opens with mu times its slip
      }
      MixedProblem p = problem_of(H, 3, 0.5);
      p.law.kind = law;
      const auto open = ranges(with_solution(std::move(p), x, u), x);
      REQUIRE(open.has_value());
      CHECK(open->directions == 1);
      for (const std::size_t k : {0U, 1U}) check_range(*open, k, 0, 2);
      for (const std::size_t k : {2U, 3U}) check_range(*open, k, 1, 3);
    }
  }
}

TEST_CASE("an error of the answer and of the matrix closes no direction") {
  // Equations depend on each other up to 1e-8 only, which is below the tolerance.
  std::vector<double> x = beam_at_rest;
  MixedProblem p = beam_on_three_feet();
  for (std::size_t e = 0; e < p.A.entries(); ++e) p.A.value[e] += 1e-8 * static_cast<double>(e % 3);
  x[1] += 1e-8;
  const auto open = ranges(p, x, 1e-6);
  REQUIRE(open.has_value());
  CHECK(open->directions == 1);
  CHECK(open->ranges.size() == 3);
  CHECK(*of_contact(*open, 1).most > 1 - 1e-6);
  CHECK(*of_contact(*open, 1).most < 1 + 1e-4);
}

TEST_CASE("walls that squeeze a block have no upper bound") {
  const std::vector<double> x{1, 0, 1, 0}, u(4, 0.0);
  MixedProblem p = with_solution(problem_of({{1, 0}, {0, 1}, {-1, 0}, {0, 1}}, 2, 0.5), x, u);
  CHECK(!ranges(p, x).has_value());  // nothing moves it: velocities have no size
  // It weighs 1: friction has to hold it, so both press with 1 at least.
  const std::vector<double> loaded{2, 0.5, 2, 0.5};
  p = with_solution(std::move(p), loaded, u);
  const auto open = ranges(p, loaded);
  REQUIRE(open.has_value());
  CHECK(open->directions == 2);
  for (const std::size_t k : {0U, 1U}) {
    CHECK(!of_contact(*open, k).most.has_value());
    CHECK(of_contact(*open, k).least <= 1);
  }
}

TEST_CASE("where forces are determined nothing is open") {
  const std::vector<double> x{1, 1}, u{0, 0};
  CHECK(!ranges(with_solution(problem_of({{1, -1}, {1, 1}}, 1, 0), x, u), x).has_value());
}

TEST_CASE("a contact that opens has no force, and holds nothing up") {
  // Two middle feet: one of them leaves with velocity 1.
  const std::vector<double> x{0.25, 0.5, 0, 0.25}, u{0, 0, 1, 0};
  const auto open = ranges(with_solution(problem_of({{1, -1}, {1, 0}, {1, 0.5}, {1, 1}}, 1, 0), x, u), x);
  REQUIRE(open.has_value());
  CHECK(open->ranges.size() == 3);
  check_range(*open, 1, 0, 1);
}

TEST_CASE("ranges of random bodies in the plane are those of exact linear programs") {
  int open_ones = 0;
  for (int round = 0; round < 60; ++round) {
    Dice dice(39, static_cast<std::uint64_t>(round));
    const auto contacts = static_cast<std::size_t>(dice.number(2, 5));
    Jacobian H;
    std::vector<double> x, u;
    const double mu = dice.number(1, 4) / 4.0;
    for (std::size_t k = 0; k < contacts; ++k) {  // feet on a floor that is not flat
      const double at = dice.number(-8, 8), height = dice.number(-2, 2) - 8;
      H.push_back({0, 1, at});
      H.push_back({1, 0, -height});
      const int mode = dice.number(0, 2);
      const double N = mode == 2 ? 0 : dice.number(1, 9);
      x.insert(x.end(), {N, mode == 1 ? -mu * N : mu * N * dice.number(-3, 3) / 4});
      u.insert(u.end(), {mode == 2 ? 1.0 : 0.0, mode == 1 ? 2.0 : 0.0});
    }
    const MixedProblem p = with_solution(problem_of(H, 2, mu), x, u);
    const auto open = ranges(p, x, 1e-12);
    if (!open) continue;
    // The forces with exactly these velocities.
    std::vector<AffineForm> constraints;
    const auto form = [&] { return AffineForm{0, std::vector<Rational>(2 * contacts)}; };
    const auto both = [&](AffineForm f) {
      constraints.push_back(f);
      f.constant = -f.constant;
      for (Rational& c : f.coefficients) c = -c;
      constraints.push_back(std::move(f));
    };
    for (std::size_t i = 0; i < p.size(); ++i) {
      AffineForm row = form();
      for (std::size_t e = p.A.starts[i]; e < p.A.starts[i + 1]; ++e) {
        const std::size_t j = p.A.column[e];
        row.coefficients[j] = to_rational(p.A.value[e]);
        row.constant -= row.coefficients[j] * to_rational(x[j]);
      }
      both(row);
    }
    for (std::size_t k = 0; k < contacts; ++k) {
      for (const int side : {1, -1}) {
        AffineForm edge = form();
        edge.coefficients[2 * k] = to_rational(mu);
        edge.coefficients[2 * k + 1] = side;
        constraints.push_back(std::move(edge));
      }
      AffineForm N = form(), T = form();
      N.coefficients[2 * k] = 1;
      T.coefficients[2 * k] = to_rational(mu);
      T.coefficients[2 * k + 1] = 1;
      constraints.push_back(N);
      if (u[2 * k] > 0) both(N);
      if (u[2 * k + 1] > 0) both(T);
    }
    LinearProgram program(2 * contacts, constraints);
    REQUIRE(program.is_feasible());
    for (const NormalRange& range : open->ranges) {
      ++open_ones;
      AffineForm N = form();
      N.coefficients[2 * range.contact] = 1;
      const Rational least = *program.least(N);
      CHECK(to_rational(range.least) <= least);
      CHECK(nearest_binary64(least) - range.least < 1e-4);
      N.coefficients[2 * range.contact] = -1;
      const auto most = program.least(N);
      CHECK(most.has_value() == range.most.has_value());
      if (!most || !range.most) continue;
      CHECK(to_rational(*range.most) >= -*most);
      CHECK(*range.most + nearest_binary64(*most) < 1e-4);
    }
  }
  CHECK(open_ones > 60);
}

TEST_CASE("an answer whose forces are held is told what is open") {
  ContactJudgeOptions options;
  const ContactJudgement j = judge_contacts(beam_on_three_feet(), beam_at_rest, {}, options);
  REQUIRE(j.open.has_value());
  CHECK(j.open->directions == 1);
  CHECK(j.verdict == ContactVerdict::ambiguous);  // without friction forces are asked for
  CHECK(j.undetermined == 1);
  CHECK(*of_contact(*j.open, 1).most > 0.999);
}

TEST_CASE("beyond the effort ranges are left out, and it is said") {
  Effort little(1000);
  const auto open = open_forces(beam_on_three_feet(), beam_at_rest, 1e-9, little);
  if (open) CHECK(!open->all);
}
