// The filter beside the kernel.
#include "mechanics/kernel/mode_filter.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "mechanics/kernel/mode_solver.hpp"
#include "mechanics/kernel/random_problem.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

/// The same problem, its unknowns in units such that hardly a coefficient is a binary64: what vanishes exactly does so
/// but for roundings there.
FrictionProblem in_odd_units(FrictionProblem problem) {
  const auto change = [&](AffineForm& form) {
    for (std::size_t i = 0; i + 1 < form.coefficients.size(); ++i) {
      form.coefficients[i] *= Rational(static_cast<long>(2 * i + 1), static_cast<long>(2 * i + 3));
    }
  };
  std::for_each(problem.equations.begin(), problem.equations.end(), change);
  std::for_each(problem.accelerations.begin(), problem.accelerations.end(), change);
  std::for_each(problem.forces.begin(), problem.forces.end(), change);
  for (ProblemElement& e : problem.elements) {
    for (AffineForm* form : {&e.gap, &e.normal, &e.slip, &e.tangent, &e.static_limit, &e.kinetic_limit}) change(*form);
  }
  return problem;
}

StatesOfElements all_states(const FrictionProblem& problem) {
  StatesOfElements all;
  for (const ProblemElement& element : problem.elements) all.push_back(states(element.kind));
  return all;
}

struct FilterCounts {
  int excluded = 0, rejected = 0, ties = 0;
};

void compare(const FrictionProblem& problem, const std::optional<Rational>& load, FilterCounts& counts) {
  const ModesOf exact = modes_of(problem, load);
  const ForceInterval domain = load || !problem.has_load ? ForceInterval() : problem.load_domain;
  const ModeFilter filter(problem, load, domain, all_states(problem));
  for (const ConsistentMode& mode : exact.consistent) {
    CAPTURE(name(mode.mode));
    CHECK_FALSE(filter.excludes(mode.mode));
    counts.ties += mode.solutions.strict ? 0 : 1;
  }
  for (const RejectedMode& mode : exact.rejected) counts.excluded += filter.excludes(mode.mode) ? 1 : 0;
  counts.rejected += static_cast<int>(exact.rejected.size());
  const std::vector<ConsistentMode> filtered = ModeSolver(problem, load).consistent();
  CHECK(std::equal(filtered.begin(), filtered.end(), exact.consistent.begin(), exact.consistent.end(),
                   [](const ConsistentMode& x, const ConsistentMode& y) {
                     return x.mode == y.mode && x.solutions.loads == y.solutions.loads;
                   }));
}

}  // namespace

TEST_CASE("the filter excludes modes without a solution, and none with one") {
  RandomProblems random(12);
  FilterCounts counts;
  for (int i = 0; i < 400; ++i) {
    CAPTURE(i);
    const FrictionProblem problem = in_odd_units(random.problem());
    compare(problem, std::nullopt, counts);
    if (!problem.has_load) continue;
    for (const Rational& load : {Rational(1), Rational(-7, 3)}) compare(problem, load, counts);
  }
  CHECK(counts.ties > 400);
  CHECK(3 * counts.excluded > counts.rejected);  // most of the others have several solutions
}

TEST_CASE("an end of the loads that is met exactly excludes nothing") {
  // 3 N = 1 + F for a contact at rest, F >= -1, and a gap that its mode leaves alone: N >= 0 where F >= -1.
  const auto form = [](const Rational& a, const Rational& N, const Rational& F, const Rational& constant) {
    return AffineForm{constant, {a, N, F}};
  };
  FrictionProblem problem;
  problem.unknowns = 2;
  problem.has_load = true;
  problem.equations = {form(-1, 3, -1, -1)};
  problem.accelerations = {form(1, 0, 0, 0)};
  ProblemElement& contact = problem.elements.emplace_back();
  contact.kind.law = ElementKind::Law::frictionless;
  contact.gap = form(1, 0, 0, 0);
  contact.normal = form(0, 1, 0, 0);
  const MechanismMode touch{ElementState::touch};
  const auto excluded = [&](const Rational& most) {
    problem.load_domain = ForceInterval::between(std::nullopt, false, most, true);
    return ModeFilter(problem, std::nullopt, problem.load_domain, all_states(problem)).excludes(touch);
  };
  CHECK_FALSE(excluded(-1));
  CHECK_FALSE(excluded(Rational(-1) - power_of_two(-80)));
  CHECK(excluded(Rational(-1) - power_of_two(-30)));
}
