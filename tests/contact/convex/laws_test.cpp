// Each law against problems that are made from their solution by it, and its closed form for one contact.
#include <doctest/doctest.h>

#include <cmath>

#include "contact/convex/lawful_problem.hpp"
#include "contact/convex/second_reading.hpp"
#include "contact/enclosure/sizes.hpp"
#include "contact/judge/certificate.hpp"
#include "contact/judge/judge.hpp"
#include "support/how_many.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

ContactLaw law_of(FrictionLaw kind, Regularisation function = Regularisation::linear) {
  ContactLaw law;
  law.kind = kind;
  law.function = function;
  return law;
}

const std::vector<ContactLaw> all_laws{
    law_of(FrictionLaw::box),         law_of(FrictionLaw::diamond),
    law_of(FrictionLaw::fixed),       law_of(FrictionLaw::associated),
    law_of(FrictionLaw::regularised), law_of(FrictionLaw::regularised, Regularisation::soft)};

LawfulProblem some_problem(std::uint64_t seed, int i, const ContactLaw& law, int most) {
  Dice dice(seed, static_cast<std::uint64_t>(i));
  const auto contacts = static_cast<std::size_t>(dice.number(1, most));
  return Lawful(dice, law).make(contacts);
}

double farthest(const std::vector<double>& a, const std::vector<double>& b) {
  double result = 0;
  for (std::size_t i = 0; i < a.size(); ++i) result = std::max(result, std::abs(a[i] - b[i]));
  return result;
}

/// A point of mass 1 on the floor, weight 10, pulled along the floor with 6.
MixedProblem pulled_point(double mu, ContactLaw law) {
  MixedProblem p;
  p.dimension = 3;
  p.A = from_dense(3, 3, std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1});
  p.c = {-10, 6, 0};
  p.mu = {mu};
  p.law = std::move(law);
  return p;
}

}  // namespace

TEST_CASE("what a problem was made from is right by its law, and by both readings of its certificate") {
  for (const ContactLaw& law : all_laws) {
    int exact = 0;
    for (int i = 0; i < how_many("SLIPPROOF_LAWFUL_PROBLEMS", 60); ++i) {
      const LawfulProblem known = some_problem(3, i, law, 6);
      const ContactJudgement found = judge_contacts(known.problem, known.x, {}, {});
      const bool convex = is_convex(known.problem);
      CHECK(found.residual->backward_error() < 1e-15);
      if (known.exact) ++exact;
      const bool pyramid = law.kind == FrictionLaw::box || law.kind == FrictionLaw::diamond;
      if (known.exact && pyramid) CHECK(found.residual->change == 0);  // other directions are rounded
      using enum ContactVerdict;
      const bool modes = law.kind == FrictionLaw::box;
      CHECK(found.verdict == (convex ? unique : modes ? solution_within_rho : eps_solution));
      const std::string certificate = contact_certificate(known.problem, found);
      CHECK(accepted(certificate));
      CHECK(second_reading(certificate) == "accepted");
    }
    CHECK(exact > 30);
  }
}

TEST_CASE("no other law calls it right where something slides") {
  int wrong = 0, all = 0;
  for (const ContactLaw& law : all_laws) {
    for (int i = 0; i < 20; ++i) {
      LawfulProblem known = some_problem(4, i, law, 6);
      const ContactJudgement by_own = judge_contacts(known.problem, known.x, {}, {});
      bool slides = false;
      for (const FittedContact& c : by_own.residual->contacts) slides = slides || c.fit == ContactFit::slide;
      if (!slides || law.kind == FrictionLaw::fixed) continue;
      for (const FrictionLaw other : {FrictionLaw::associated, FrictionLaw::box}) {
        if (other == law.kind || (law.kind == FrictionLaw::diamond && other == FrictionLaw::box)) continue;
        ++all;
        known.problem.law = law_of(other);
        const double error = judge_contacts(known.problem, known.x, {}, {}).residual->backward_error();
        wrong += error > 1e-6 ? 1 : 0;
      }
    }
  }
  CHECK(all > 40);
  CHECK(wrong > all * 9 / 10);
}

TEST_CASE("what is certified of a spoiled answer by another law contains the solution") {
  int certified = 0, all = 0;
  for (const FrictionLaw kind : {FrictionLaw::fixed, FrictionLaw::associated, FrictionLaw::box}) {
    for (int i = 0; i < how_many("SLIPPROOF_SPOILED_LAWFUL", 100); ++i) {
      const LawfulProblem known = some_problem(5, i, law_of(kind), i % 20 == 0 ? 40 : 5);
      Dice dice(6, static_cast<std::uint64_t>(i));
      std::vector<double> answer = known.x;
      const double off = std::pow(10.0, -dice.number(2, 14));
      for (double& x : answer) x = x * (1 + off * dice.number(-9, 9)) + (dice.chance(5) ? off : 0);
      const ContactJudgement found = judge_contacts(known.problem, answer, {}, {});
      if (!known.exact) continue;  // the solution is another one
      ++all;
      if (is_certified(found.verdict)) ++certified;
      const double away = farthest(known.x, answer);
      if (found.has_solution()) CHECK(found.rho >= away * (1 - 1e-12));
      const double size =
          std::max(farthest(known.x, std::vector<double>(known.x.size(), 0)), contact_sizes(known.problem).force);
      if (is_certified(found.verdict)) CHECK(away < 1e-5 * size);
      if (!found.every) continue;
      for (std::size_t j = 0; j < known.x.size(); ++j) {
        CHECK(abs(found.every->point[j] - to_rational(known.x[j])) <= to_rational(found.every->radius[j]));
        const Rational u = exact_row(known.problem, j, std::span<const double>(known.x));
        const Rational at = exact_row(known.problem, j, std::span<const double>(answer));
        CHECK(abs(u - at) <= to_rational(found.every->eta));
      }
      const std::string certificate = contact_certificate(known.problem, found);
      if (!certificate.empty()) CHECK(accepted(certificate));
    }
  }
  CHECK(certified > all / 3);
}

TEST_CASE("an error whose square underflows is an error") {
  MixedProblem p = pulled_point(0.5, law_of(FrictionLaw::associated));
  p.c = {-10, 0, 0};  // it sticks: r = (10, 0, 0)
  const std::vector<double> answer{10, 0x1p-1074, 0};
  Effort effort(1'000'000'000);
  const auto found = every_solution(p, answer, answer, *prove_monotone(p, effort));
  REQUIRE(found);
  CHECK(found->energy > 0);
  const std::vector<Rational> solution{10, 0, 0};
  for (std::size_t j = 0; j < solution.size(); ++j) {
    CHECK(abs(found->point[j] - solution[j]) <= to_rational(found->radius[j]));
  }
}

TEST_CASE("one contact by each law, in closed form") {
  // Coulomb: r = (10, -5, 0), u = (0, 1, 0). Associated: r is the projection of (10, -6, 0) onto the cone.
  const double mu = 0.5, N = (10 + mu * 6) / (1 + mu * mu);
  const auto verdict = [&](const ContactLaw& law, std::vector<double> r) {
    return judge_contacts(pulled_point(mu, law), std::move(r), {}, {}).verdict;
  };
  using enum ContactVerdict;
  CHECK(verdict(law_of(FrictionLaw::cone), {10, -5, 0}) == solution_within_rho);
  CHECK(verdict(law_of(FrictionLaw::box), {10, -5, 0}) == solution_within_rho);
  CHECK(verdict(law_of(FrictionLaw::associated), {N, -mu * N, 0}) == unique);
  CHECK(verdict(law_of(FrictionLaw::associated), {10, -5, 0}) == wrong);
  CHECK(verdict(law_of(FrictionLaw::cone), {N, -mu * N, 0}) == wrong);
  ContactLaw fixed = law_of(FrictionLaw::fixed);
  fixed.bounds = {2, 2};
  CHECK(verdict(fixed, {10, -2, 0}) == unique);
  CHECK(verdict(fixed, {10, -5, 0}) == wrong);
  // Regularised: u = 6 + r_T; with v_s = 2 the linear law has u = 1 on its edge, and below it r = -5 u / 2.
  ContactLaw slow = law_of(FrictionLaw::regularised);
  slow.slip_speed = 2;
  CHECK(verdict(slow, {10, -5 * (6 / 3.5) / 2, 0}) == eps_solution);
  CHECK(verdict(slow, {10, -5, 0}) == wrong);
  slow.slip_speed = 0.5;
  CHECK(verdict(slow, {10, -5, 0}) == eps_solution);
  // Soft, with v_s = 4/3 u: r_T = -5 * 3/5, u = 3.
  slow.function = Regularisation::soft;
  slow.slip_speed = 4;
  CHECK(verdict(slow, {10, -3, 0}) == eps_solution);
  CHECK(verdict(slow, {10, -3.01, 0}) == wrong);
}

TEST_CASE("a compliance that is far from the solution is told so, and a radius makes the difference") {
  MixedProblem p = pulled_point(0.5, law_of(FrictionLaw::cone));
  ContactJudgeOptions options;
  CHECK(judge_contacts(p, {10.01, -5, 0}, {}, options).verdict == ContactVerdict::not_converged);
  options.within = 1e-3;
  CHECK(judge_contacts(p, {10.01, -5, 0}, {}, options).verdict == ContactVerdict::none_within_rho);
  options.within = 0.1;
  CHECK(judge_contacts(p, {10.01, -5, 0}, {}, options).verdict == ContactVerdict::not_converged);
  options.within = 4;
  options.refine = true;
  CHECK(judge_contacts(p, {12, -5, 0}, {}, options).verdict == ContactVerdict::not_converged);
  options.within.reset();
  CHECK(judge_contacts(p, {12, -5, 0}, {}, options).verdict == ContactVerdict::wrong);
}

TEST_CASE("where nothing determines the forces, velocities are certified by convex laws") {
  // A body of mass 2 and unit inertia on four corners of the floor, by its velocities: forces are open.
  MixedProblem p;
  p.free = 6;
  p.dimension = 3;
  p.law = law_of(FrictionLaw::associated);
  std::vector<double> A(18 * 18, 0);
  const auto at = [&](std::size_t i, std::size_t j) -> double& { return A[i * 18 + j]; };
  for (std::size_t i = 0; i < 6; ++i) at(i, i) = i < 3 ? 2 : 1;
  const std::array<std::array<double, 2>, 4> corners{{{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto [x, y] = corners[k];
    const double z = -0.5;
    // Velocity of the corner: v + w x r; rows are (z, x, y).
    const std::array<std::array<double, 6>, 3> rows{{{0, 0, 1, y, -x, 0}, {1, 0, 0, 0, z, -y}, {0, 1, 0, -z, 0, x}}};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 6; ++j) {
        at(6 + 3 * k + i, j) = rows[i][j];
        at(j, 6 + 3 * k + i) = -rows[i][j];
      }
    }
  }
  p.A = from_dense(18, 18, A);
  p.c.assign(18, 0);
  p.c[2] = 20;  // weight: M v = H r + f
  p.mu.assign(4, 0.5);
  const auto with = [](std::vector<double> v, double right, double left, double friction) {
    v.resize(6, 0);
    for (const double N : {right, right, left, left}) v.insert(v.end(), {N, -friction * N, 0});
    return v;
  };
  // Pulled with 2 it stays; pulled with 20 it slides with 4 and, by this law, rises with 2. The moment of the friction
  // is balanced by the normal forces in front.
  for (const bool slides : {false, true}) {
    p.c[0] = slides ? -20 : -2;
    std::vector<double> x = slides ? with({4, 0, 2}, 7.5, 4.5, 0.5) : with({}, 5.25, 4.75, 0.1);
    const ContactJudgement found = judge_contacts(p, x, {}, {});
    using enum ContactVerdict;
    CHECK(found.verdict == (slides ? velocities_within_rho : solution_within_rho));
    CHECK(found.every->eta < 1e-6);
    CHECK(found.undetermined == (slides ? 12 : 6));
    const std::string certificate = contact_certificate(p, found);
    CHECK(accepted(certificate));
    CHECK(second_reading(certificate) == "accepted");
    x[6] += 0.1;  // the body would turn
    x[9] -= 0.1;
    CHECK(!is_certified(judge_contacts(p, x, {}, {}).verdict));
  }
}
