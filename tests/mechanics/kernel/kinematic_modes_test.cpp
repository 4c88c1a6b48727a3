// Motions by kinematics against all modes, on random mechanisms, and where there are too many modes to try.
#include "mechanics/kernel/kinematic_modes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "mechanics/kernel/motions.hpp"
#include "mechanics/kernel/motions_over_loads.hpp"
#include "mechanics/kernel/random_problem.hpp"
#include "support/how_many.hpp"

using namespace slipproof;

namespace {

bool holds(const Range& range, const Rational& x) {
  return (!range.lower || *range.lower <= x) && (!range.upper || x <= *range.upper);
}

/// Whether a motion is among those found, alone or perhaps in a continuum.
bool is_among(const MotionsAtLoad& found, const std::vector<Rational>& accelerations) {
  const auto same = [&](const MotionAtLoad& motion) { return motion.accelerations == accelerations; };
  const auto in_ranges = [&](const ContinuumAtLoad& c) {
    return std::ranges::equal(c.accelerations, accelerations, holds);
  };
  return std::ranges::any_of(found.motions, same) || std::ranges::any_of(found.continua, in_ranges);
}

/// A beam on feet of equal distance, pressed into the floor by its weight and pushed to the side: the unknowns are
/// ax, ay, alpha, then N and S of each foot. Mass, radius of inertia and gravity are 1.
FrictionProblem beam(std::size_t feet, const Rational& mu, const Rational& push, const Rational& lift) {
  FrictionProblem p;
  p.unknowns = 3 + 2 * feet;
  const auto form = [&] { return AffineForm{0, std::vector<Rational>(p.unknowns + 1)}; };
  for (std::size_t i = 0; i < 3; ++i) {
    p.equations.push_back(form());
    p.equations.back().coefficients[i] = 1;
    p.accelerations.push_back(p.equations.back());
  }
  p.equations[0].constant = -push;
  p.equations[1].constant = 1 - lift;
  for (std::size_t k = 0; k < feet; ++k) {
    const Rational x = Rational(static_cast<int>(2 * k), static_cast<int>(feet) - 1) - 1, height = Rational(1, 4);
    ProblemElement e;
    e.kind.law = ElementKind::Law::coulomb;
    for (AffineForm* part : {&e.gap, &e.slip, &e.normal, &e.tangent, &e.static_limit}) *part = form();
    e.gap.coefficients[1] = 1, e.gap.coefficients[2] = x;
    e.slip.coefficients[0] = 1, e.slip.coefficients[2] = height;
    const std::size_t N = 3 + 2 * k, S = N + 1;
    e.normal.coefficients[N] = 1, e.tangent.coefficients[S] = 1, e.static_limit.coefficients[N] = mu;
    e.kinetic_limit = e.static_limit;
    p.equations[1].coefficients[N] = -1, p.equations[2].coefficients[N] = -x;
    p.equations[0].coefficients[S] = -1, p.equations[2].coefficients[S] = -height;
    p.forces.push_back(e.normal);
    p.elements.push_back(std::move(e));
  }
  return p;
}

/// A body of mass 1 on contacts at random points with random normals, in small numbers, under a random force and
/// moment.
FrictionProblem random_body(test::RandomProblems& random, std::size_t contacts) {
  FrictionProblem p = beam(contacts, 0, 0, 0);
  const std::array<std::array<int, 3>, 4> triples{{{0, 1, 1}, {3, 4, 5}, {4, 3, 5}, {5, 12, 13}}};
  for (std::size_t i = 0; i < 3; ++i) {
    p.equations[i] = p.accelerations[i];
    p.equations[i].constant = random.integer(-4, 4);
  }
  p.equations[2].coefficients[2] = Rational(random.integer(1, 4), 4);
  for (std::size_t k = 0; k < contacts; ++k) {
    const auto& [a, b, c] = triples[static_cast<std::size_t>(random.integer(0, 3))];
    const Rational nx = Rational(random.one_in(2) ? a : -a, c), ny = Rational(random.one_in(4) ? -b : b, c);
    const Rational x = random.integer(-3, 3), y = random.integer(-2, 1);
    // Along the normal (nx, ny) and the tangent (ny, -nx): the velocity of the point is (vx - w y, vy + w x).
    const auto along = [&](AffineForm& form, const Rational& dx, const Rational& dy) {
      form.coefficients[0] = dx, form.coefficients[1] = dy, form.coefficients[2] = x * dy - y * dx;
    };
    ProblemElement& e = p.elements[k];
    along(e.gap, nx, ny);
    along(e.slip, ny, -nx);
    const std::size_t N = 3 + 2 * k, S = N + 1;
    e.static_limit.coefficients[N] = Rational(random.integer(0, 6), 4);
    e.kinetic_limit = e.static_limit;
    for (std::size_t i = 0; i < 3; ++i) {  // virtual work
      p.equations[i].coefficients[N] = -e.gap.coefficients[i];
      p.equations[i].coefficients[S] = -e.slip.coefficients[i];
    }
  }
  return p;
}

/// A block of weight 1 that is pushed along the floor, beside five others that are not pushed. Each has the unknowns x,
/// y, N and S.
FrictionProblem six_blocks(const Rational& mu_s, const Rational& mu_k, const Rational& push, int weight_of_others) {
  FrictionProblem p;
  p.unknowns = 24;
  p.has_load = true;
  const auto unit = [&](std::size_t i, const Rational& factor) {
    AffineForm form{0, std::vector<Rational>(p.unknowns + 1)};
    form.coefficients[i] = factor;
    return form;
  };
  for (std::size_t i = 0; i < 24; i += 4) {
    ProblemElement e;
    e.kind.law = ElementKind::Law::coulomb;
    e.slip = unit(i, 1), e.gap = unit(i + 1, 1), e.normal = unit(i + 2, 1), e.tangent = unit(i + 3, 1);
    e.static_limit = unit(i + 2, mu_s), e.kinetic_limit = unit(i + 2, mu_k);
    p.accelerations.insert(p.accelerations.end(), {e.slip, e.gap});
    p.forces.insert(p.forces.end(), {e.normal, e.tangent});
    p.equations.insert(p.equations.end(), {e.slip - e.tangent, e.gap - e.normal});
    p.equations.back().constant = i == 0 ? 1 : weight_of_others;
    p.elements.push_back(std::move(e));
  }
  p.equations[0].constant = -push;
  p.equations[0].coefficients.back() = -1;
  return p;
}

MechanismMode first_of_six(ElementState state, ElementState others = ElementState::stick) {
  MechanismMode mode(6, others);
  mode[0] = state;
  return mode;
}

}  // namespace

TEST_CASE("a body on two to seven contacts has the motions that all of its modes have") {
  const int bodies = test::how_many("SLIPPROOF_RANDOM_BODIES", 120);
  test::RandomProblems random(41);
  int motions = 0, several = 0, none = 0;
  for (int i = 0; i < bodies; ++i) {
    const int most = i % 40 == 0 ? 6 : 5;  // all of 4^7 modes take a second
    const auto contacts = static_cast<std::size_t>(bodies > 120 ? random.integer(2, 7) : random.integer(2, most));
    const FrictionProblem problem = random_body(random, contacts);
    CAPTURE(i);
    Effort effort(kinematic_effort);
    const MergedModes all = merge(problem, ModeSolver(problem, std::nullopt).consistent());
    const MotionsAtLoad found = motions_by_kinematics(problem, std::nullopt, effort);
    for (const MergedModes::Motion& motion : all.motions) CHECK(is_among(found, motion.accelerations));
    CHECK(all.continua.empty() == found.continua.empty());
    if (all.continua.empty()) CHECK(all.motions.size() == found.motions.size());
    motions += static_cast<int>(all.motions.size());
    several += all.motions.size() > 1 ? 1 : 0;
    none += all.motions.empty() && all.continua.empty() ? 1 : 0;
  }
  CHECK(motions > bodies / 2);
  CHECK(several > 0);
  MESSAGE(motions << " motions, several of " << several << " bodies, none of " << none);
}

TEST_CASE("by kinematics random mechanisms have the motions that all modes have") {
  test::RandomProblems random(39);
  int motions = 0, continua = 0;
  const int rounds = test::how_many("SLIPPROOF_RANDOM_MECHANISMS", 400);
  for (int round = 0; round < rounds; ++round) {
    const FrictionProblem problem = random.problem();
    const std::optional<Rational> load =
        problem.has_load ? std::optional(Rational(random.integer(-4, 4))) : std::nullopt;
    CAPTURE(round);
    Effort effort(1'000'000'000);
    const MotionsAtLoad all = motions_of(problem, load), found = motions_by_kinematics(problem, load, effort);
    for (const MotionAtLoad& motion : all.motions) CHECK(is_among(found, motion.accelerations));
    for (const MotionAtLoad& motion : found.motions) CHECK(is_among(all, motion.accelerations));
    CHECK(all.continua.empty() == found.continua.empty());
    if (all.continua.empty()) CHECK(all.motions.size() == found.motions.size());
    motions += static_cast<int>(all.motions.size());
    continua += static_cast<int>(all.continua.size());
  }
  CHECK(motions > 100);
  CHECK(continua > 10);
}

TEST_CASE("over all loads the modes by kinematics have the cells of all modes") {
  test::RandomProblems random(40);
  int compared = 0;
  for (int round = 0; round < 200; ++round) {
    const FrictionProblem problem = random.problem();
    if (!problem.has_load) continue;
    Effort effort(1'000'000'000);
    const auto all = cells_of(problem, ModeSolver(problem, std::nullopt).consistent());
    const auto found = cells_of(problem, kinematic_modes(problem, std::nullopt, effort));
    CAPTURE(round);
    for (const LoadCell& cell : found) {  // each has as many motions as all modes have there
      const auto same =
          std::ranges::find_if(all, [&](const LoadCell& other) { return other.loads.contains(cell.loads.sample()); });
      REQUIRE(same != all.end());
      if (same->continua.empty() && cell.continua.empty()) CHECK(same->motions.size() == cell.motions.size());
      CHECK(same->continua.empty() == cell.continua.empty());
    }
    compared += static_cast<int>(found.size());
  }
  CHECK(compared > 200);
}

TEST_CASE("a beam on 24 feet rests, slides, tips or leaves the floor") {
  Effort effort(100'000'000'000);
  const auto only = [&](const FrictionProblem& problem) {
    const MotionsAtLoad found = motions_by_kinematics(problem, std::nullopt, effort);
    REQUIRE(found.motions.size() == 1);
    CHECK(found.continua.empty());
    return found.motions[0].accelerations;
  };
  CHECK(only(beam(24, Rational(1, 2), Rational(1, 4), 0)) == std::vector<Rational>{0, 0, 0});
  CHECK(only(beam(24, Rational(1, 2), 1, 0)) == std::vector<Rational>{Rational(1, 2), 0, 0});
  CHECK(only(beam(24, Rational(1, 2), 0, 2)) == std::vector<Rational>{0, 1, 0});
}

TEST_CASE("modes that were not tried are found when they are asked for") {
  FrictionProblem pushed = beam(6, Rational(1, 2), 0, 0);
  pushed.has_load = true;
  pushed.equations[0].coefficients[pushed.load_index()] = -1;
  REQUIRE(has_too_many_to_try(pushed));
  const auto motions = motions_over_loads(pushed);
  MechanismMode mode(6, ElementState::stick);
  CHECK(motions->find(mode)->closed->contains(Rational(1, 4)));
  mode[2] = mode[3] = ElementState::lift;  // at rest, with a gap of 0: a border, which kinematics does not list
  CHECK(motions->find(mode)->closed->contains(Rational(1, 4)));
  CHECK(motions->find(mode)->strict->empty());
  mode.assign(6, ElementState::slip_forward);
  CHECK_FALSE(motions->find(mode)->closed->contains(Rational(1, 4)));
  CHECK(motions->find(mode)->strict->contains(Rational(3, 4)));
}

TEST_CASE("beyond 1024 modes hysteresis is told, and every rejected mode") {
  const MechanismMode rests = first_of_six(ElementState::stick), slips = first_of_six(ElementState::slip_forward);
  const FrictionProblem pushed = six_blocks(Rational(3, 4), Rational(1, 4), Rational(1, 2), 1);
  REQUIRE(has_too_many_to_try(pushed));
  const MotionsAtLoad by_kinematics = motions_of(pushed, Rational(0));
  CHECK(by_kinematics.by_kinematics);
  CHECK(by_kinematics.motions.size() == 2);
  CHECK(by_kinematics.hysteresis == std::vector<MechanismMode>{rests});
  const MotionsAtLoad all = motions_of(pushed, Rational(0), Listing::modes);
  CHECK_FALSE(all.by_kinematics);
  REQUIRE(all.motions.size() == 2);
  CHECK(all.motions[0].modes == std::vector<MechanismMode>{rests});
  CHECK(all.motions[1].modes == std::vector<MechanismMode>{slips});
  CHECK(all.hysteresis == std::vector<MechanismMode>{rests});
  CHECK(all.rejected.size() == 4094);
}

TEST_CASE("beyond 1024 modes every boundary mode is told, or those that are named") {
  // What neither weighs nor is pushed stays where it is in all four states, each of them at its border.
  const FrictionProblem at_rest = six_blocks(Rational(1, 2), Rational(1, 2), Rational(1, 4), 0);
  const MotionsAtLoad all = motions_of(at_rest, Rational(0), Listing::modes);
  REQUIRE(all.motions.size() == 1);
  CHECK(all.motions[0].modes.empty());
  CHECK(all.motions[0].boundary_modes.size() == 1024);
  CHECK(all.rejected.size() == 3072);
  const MechanismMode border = first_of_six(ElementState::stick, ElementState::lift);
  const auto detail = [&](const std::vector<MechanismMode>& named) {
    for (const LoadCell& cell : motions_over_loads(at_rest)->cells(Detail::modes, named)) {
      if (!cell.loads.contains(0)) continue;
      REQUIRE(cell.motions.size() == 1);
      return std::ranges::count(cell.motions[0].boundary_modes, border) == 1;
    }
    return false;
  };
  CHECK(detail({border}));
  CHECK_FALSE(detail({}));
  CHECK_FALSE(detail({first_of_six(ElementState::lift)}));
}
