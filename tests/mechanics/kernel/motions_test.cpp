#include "support/bicycle/motions.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "mechanics/kernel/motions.hpp"
#include "support/scenes/friction_problems.hpp"
#include "support/scenes/random_scene.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

std::set<std::string> names(const std::vector<MechanismMode>& modes) {
  std::set<std::string> result;
  for (const auto& mode : modes) result.insert(name(mode));
  return result;
}
std::set<std::string> names(const std::vector<ContactMode>& modes) {
  std::set<std::string> result;
  for (const auto& mode : modes) result.insert(name(mode));
  return result;
}

std::vector<Rational> accelerations(const Motion<Rational>& motion) {
  std::vector<Rational> result;
  for (const Quantity q : all_quantities()) {
    if (q < Quantity::S2 || q > Quantity::N3) result.push_back(motion[q]);
  }
  return result;
}

/// The modes of each motion by its accelerations, and whether it is strict.
using Found = std::map<std::vector<Rational>, std::pair<std::set<std::string>, bool>>;

Found found_by_table(const MotionsAtForce& at) {
  Found result;
  for (const auto& motion : at.motions) {
    auto& entry = result[accelerations(motion.values)];
    entry.first.merge(names(motion.modes));
    entry.second = entry.second || motion.strict;
  }
  return result;
}

Found found_by_kernel(const MotionsAtLoad& at) {
  Found result;
  for (const auto& motion : at.motions) {
    std::vector<Rational> key = motion.accelerations;
    key.pop_back();  // eps1 follows from eps2 and phi
    auto& entry = result[std::move(key)];
    entry.first.merge(names(motion.modes));
    entry.first.merge(names(motion.boundary_modes));
    entry.second = motion.strict();
  }
  return result;
}

}  // namespace

TEST_CASE("bicycles have the motions that the table of their 16 modes gives") {
  RandomScenes random(15);
  int several = 0, none = 0, on_boundary = 0;
  for (int i = 0; i < 300; ++i) {
    const Bicycle<Rational> p = i % 3 == 0 ? random.reduced(true) : random.bicycle(i % 4 != 0);
    const Road<Rational> road = random.road();
    const ForceKind kind = i % 2 == 0 ? ForceKind::internal : ForceKind::external;
    const FrictionProblem problem = bicycle_problem(p, road, kind);
    const ModeTable table(p, road, kind);
    const auto modes = modes_of(without_equations(problem), std::nullopt).consistent;
    std::set<std::string> expected, all;
    std::vector<Rational> loads{0, random.any() * 10, random.any() * 100};
    for (const ModeSolution& s : table.solutions()) {
      if (s.closed().empty()) continue;
      expected.insert(name(s.mode()));
      if (s.closed().lower()) loads.push_back(*s.closed().lower());
      if (s.closed().upper()) loads.push_back(*s.closed().upper());
      const auto same = std::find_if(modes.begin(), modes.end(),
                                     [&](const ConsistentMode& m) { return name(m.mode) == name(s.mode()); });
      REQUIRE(same != modes.end());
      CHECK(same->solutions.loads == s.closed());
      CHECK(strict_loads(same->solutions) == s.strict());
    }
    for (const ConsistentMode& mode : modes) all.insert(name(mode.mode));
    CHECK(all == expected);
    for (const Rational& F : loads) {
      const Found by_table = found_by_table(motions_at(table, F));
      CHECK(found_by_kernel(motions_of(problem, F)) == by_table);
      several += by_table.size() > 1 ? 1 : 0;
      none += by_table.empty() ? 1 : 0;
      for (const auto& [key, motion] : by_table) on_boundary += motion.second ? 0 : 1;
    }
  }
  CHECK(several > 20);
  CHECK(none > 20);
  CHECK(on_boundary > 20);
}

TEST_CASE("a bicycle's loads are parted as by the table of its modes") {
  RandomScenes random(16);
  for (int i = 0; i < 60; ++i) {
    const Bicycle<Rational> p = i % 3 == 0 ? random.reduced(true) : random.bicycle(true);
    const Road<Rational> road = random.road();
    const ForceKind kind = i % 2 == 0 ? ForceKind::internal : ForceKind::external;
    const FrictionProblem problem = without_equations(bicycle_problem(p, road, kind));
    const auto cells = cells_of(problem, modes_of(problem, std::nullopt).consistent);
    for (const Cell& expected : partition(ModeTable(p, road, kind))) {
      const Rational inside = expected.forces.sample();
      const auto cell =
          std::find_if(cells.begin(), cells.end(), [&](const LoadCell& c) { return c.loads.contains(inside); });
      REQUIRE(cell != cells.end());
      std::set<std::set<std::string>> modes, wanted;
      for (const auto& motion : cell->motions) {
        auto all = names(motion.modes);
        all.merge(names(motion.boundary_modes));
        modes.insert(std::move(all));
      }
      for (const auto& motion : expected.motions) wanted.insert(names(motion.modes));
      CHECK(modes == wanted);
      for (const auto& motion : cell->motions) {
        const auto same = std::find_if(expected.motions.begin(), expected.motions.end(), [&](const auto& m) {
          return names(m.modes).count(name(motion.modes.empty() ? motion.boundary_modes[0] : motion.modes[0])) > 0;
        });
        REQUIRE(same != expected.motions.end());
        CHECK(motion.accelerations[0].at(inside) == same->values[Quantity::a].at(inside));
        REQUIRE(motion.forces[2]);
        CHECK(motion.forces[2]->at(inside) == same->values[Quantity::N2].at(inside));
      }
    }
  }
}

namespace {

/// Rods in two guides that slide: N1 + N2 = L and S1 + S2 = -2 with S = -|N|, so one of them pulls, either.
FrictionProblem two_guides() {
  FrictionProblem p;
  p.unknowns = 5;  // x, N1, S1, N2, S2
  p.has_load = true;
  const auto form = [](int constant, std::vector<Rational> coefficients) {
    return AffineForm{constant, std::move(coefficients)};
  };
  p.equations = {form(0, {1, 0, 0, 0, 0, 0}), form(0, {0, 1, 0, 1, 0, -1}), form(2, {0, 0, 1, 0, 1, 0})};
  p.accelerations = {p.equations[0]};
  p.forces = {form(0, {0, 1, 0, 0, 0, 0}), form(0, {0, 0, 1, 0, 0, 0})};
  for (const bool first : {true, false}) {
    ProblemElement e;
    e.kind.bilateral = true;
    e.kind.start = ElementKind::Start::slides_forward;
    e.gap = e.slip = p.equations[0];
    e.normal = first ? form(0, {0, 1, 0, 0, 0, 0}) : form(0, {0, 0, 0, 1, 0, 0});
    e.tangent = first ? form(0, {0, 0, 1, 0, 0, 0}) : form(0, {0, 0, 0, 0, 1, 0});
    e.static_limit = e.kinetic_limit = e.normal;
    p.elements.push_back(std::move(e));
  }
  return p;
}

}  // namespace

TEST_CASE("a force in which modes of one motion differ is undetermined, though they agree at one load") {
  const FrictionProblem p = two_guides();
  const auto at_zero = motions_of(p, Rational(0)).motions;  // S1 is -(2 + L)/2 in one mode, -(2 - L)/2 in the other
  REQUIRE(at_zero.size() == 1);
  CHECK(names(at_zero[0].modes) == std::set<std::string>{"slip+/slip+~", "slip+~/slip+"});
  CHECK(at_zero[0].forces[1] == Range{-1, -1});
  const auto cells = cells_of(p, modes_of(p, std::nullopt).consistent);
  const auto around = std::find_if(cells.begin(), cells.end(), [](const LoadCell& c) { return c.loads.contains(0); });
  REQUIRE(around != cells.end());
  CHECK(to_string(around->loads) == "(-2, 2)");
  REQUIRE(around->motions.size() == 1);
  CHECK_FALSE(around->motions[0].forces[1]);
}

TEST_CASE("a domain without a load has no cells, and no modes") {
  FrictionProblem p = two_guides();
  p.load_domain = ForceInterval::nothing();
  const ModesOf modes = modes_of(p, std::nullopt);
  CHECK(modes.consistent.empty());
  CHECK(modes.rejected.size() == 4);
  CHECK(cells_of(p, modes.consistent).empty());
}
