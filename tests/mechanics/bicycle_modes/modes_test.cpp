#include <doctest/doctest.h>

#include <algorithm>
#include <map>

#include "mechanics/bicycle/conditions.hpp"
#include "mechanics/bicycle_modes/motions.hpp"
#include "support/random_scene.hpp"

using namespace slipproof;
using slipproof::test::RandomScenes;

namespace {

std::vector<std::string> names(const std::vector<ContactMode>& modes) {
  std::vector<std::string> result;
  for (const auto m : modes) result.push_back(name(m));
  return result;
}

/// Consistency of a regular mode at a force, non-strict and strict, from its motion alone.
std::pair<bool, bool> judge(const ModeSolution& s, const Rational& f, const Rational& F) {
  const auto motion = s.motion();
  bool closed = true, strict = true;
  for (const Condition& c : conditions(s.mode())) {
    const Rational value = condition_value(c, motion, f).at(F);
    closed = closed && value >= 0;
    strict = strict && value > 0;
  }
  return {closed, strict};
}

}  // namespace

TEST_CASE("interval of F: membership is consistency, inside, outside and on the ends") {
  RandomScenes random(11);
  int ends = 0;
  for (int i = 0; i < 60; ++i) {
    const auto p = random.bicycle(true);
    const auto road = random.road();
    const ModeTable table(p, road, i % 2 == 0 ? ForceKind::internal : ForceKind::external);
    for (const ModeSolution& s : table.solutions()) {
      if (s.kind() != ModeSolution::Kind::regular) continue;
      std::vector<Rational> forces{0, random.any(), random.any() * 10, random.any() * 1000};
      for (const auto& end : {s.closed().lower(), s.closed().upper()}) {
        if (!end) continue;
        ++ends;
        forces.insert(forces.end(), {*end, *end - Rational(1, 1000000), *end + Rational(1, 1000000)});
      }
      for (const Rational& F : forces) {
        const auto [closed, strict] = judge(s, road.f, F);
        CHECK(s.closed().contains(F) == closed);
        CHECK(s.strict().contains(F) == strict);
      }
    }
  }
  CHECK(ends > 200);
}

TEST_CASE("cells: their motions are those found at a force inside, and they cover the line in order") {
  RandomScenes random(12);
  for (int i = 0; i < 40; ++i) {
    auto p = random.bicycle(i % 4 != 0);
    auto road = random.road();
    if (i % 5 == 0) road.f = 0;
    const ModeTable table(p, road, i % 2 == 0 ? ForceKind::internal : ForceKind::external);
    const auto cells = partition(table);
    REQUIRE(cells.size() % 2 == 1);
    CHECK_FALSE(cells.front().forces.lower());
    CHECK_FALSE(cells.back().forces.upper());
    for (std::size_t k = 0; k < cells.size(); ++k) {
      CHECK(cells[k].forces.is_point() == (k % 2 == 1));
      if (k > 0) CHECK(*cells[k - 1].forces.upper() == *cells[k].forces.lower());
      std::vector<Rational> inside{cells[k].forces.sample()};
      if (!cells[k].forces.is_point() && cells[k].forces.lower() && cells[k].forces.upper()) {
        inside.push_back((*cells[k].forces.lower() * 7 + *cells[k].forces.upper()) / 8);
      }
      for (const Rational& F : inside) {
        const auto found = motions_at(table, F);
        REQUIRE(found.motions.size() == cells[k].motions.size());
        for (std::size_t m = 0; m < found.motions.size(); ++m) {
          CHECK(names(found.motions[m].modes) == names(cells[k].motions[m].modes));
          CHECK(found.motions[m].strict == cells[k].motions[m].strict);
          for (const Quantity q : all_quantities()) {
            CHECK(found.motions[m].values[q] == cells[k].motions[m].values[q].at(F));
          }
        }
      }
    }
  }
}

TEST_CASE("every mode is accounted for; rejections name a violated condition with its exact margin") {
  RandomScenes random(13);
  for (int i = 0; i < 30; ++i) {
    const auto p = random.bicycle(true);
    const auto road = random.road();
    const Rational F = random.any();
    const ModeTable table(p, road, ForceKind::internal);
    const auto found = motions_at(table, F);
    std::size_t modes = found.rejected.size() + found.continua.size();
    for (const auto& m : found.motions) modes += m.modes.size();
    CHECK(modes == 16);
    for (const Rejection& r : found.rejected) {
      REQUIRE(r.violated);
      CHECK(r.margin < 0);
      CHECK(condition_value(*r.violated, table.find(r.mode)->motion(), road.f).at(F) == r.margin);
    }
  }
}

// With J and all inertias positive the Delassus matrix W is positive definite. A solution of the homogeneous contact
// problem has lambda.W lambda = sum of N gap + S slip <= 0, so it is zero: the degree of the contact map is defined for
// every f and the same as for f = 0, which is 1. At a generic force every motion is strict and counts +1 or -1.
TEST_CASE("the number of strict motions of a generic scene with J is odd") {
  RandomScenes random(14);
  std::map<std::size_t, int> counts;
  for (int i = 0; i < 300; ++i) {
    auto p = random.bicycle(true);
    if (i % 3 == 0) *p.J /= 1000;
    if (p.b2 == 0 || p.L == 0) continue;  // not generic: the front wheel carries nothing, or the force does nothing
    const ModeTable table(p, random.road(), i % 2 == 0 ? ForceKind::internal : ForceKind::external);
    for (const Cell& cell : partition(table)) {
      if (cell.forces.is_point()) continue;
      CHECK(cell.continua.empty());
      CHECK(cell.strict_count() % 2 == 1);
      ++counts[cell.strict_count()];
    }
  }
  for (const auto& [n, times] : counts) MESSAGE(times << " cells with " << n << " strict motions");
  CHECK(counts[3] > 0);  // the ambiguity is among the samples
}

TEST_CASE("without J the number of motions may be even: the one that lifts the front wheel is not modelled") {
  // The ambiguous region of Assertion 5: R = h = g = M2 = M3 = 1, f = 4, b = 1/2 < b1 = 1, xi3 = 1/3 < F < xi2 = 6/17.
  Bicycle<Rational> p{.M = 1,
                      .R = 1,
                      .h = 1,
                      .b2 = Rational(1, 2),
                      .b3 = Rational(1, 2),
                      .I1 = 0,
                      .I2 = 1,
                      .I3 = 1,
                      .r1 = 1,
                      .r2 = 1,
                      .L = 1};
  const Road<Rational> road{4, 1};
  const Rational F(7, 20);
  CHECK(motions_at(ModeTable(p, road, ForceKind::internal), F).motions.size() == 2);
  for (const Rational& J : {Rational(1, 1000), Rational(1), Rational(1000)}) {
    p.J = J;
    const auto found = motions_at(ModeTable(p, road, ForceKind::internal), F);
    REQUIRE(found.motions.size() == 3);
    CHECK(names(found.motions[0].modes) == std::vector<std::string>{"stick/stick"});
    CHECK(names(found.motions[1].modes) == std::vector<std::string>{"stick/slip+"});
    CHECK(names(found.motions[2].modes) == std::vector<std::string>{"stick/lift"});
  }
}

TEST_CASE("why a singular mode has no motion: no solution of its equations, or none that meets the conditions") {
  // Wheels without inertia: hanging in the air they may spin as they like, and the rear one takes no moment.
  const Bicycle<Rational> p{
      .M = 1, .R = 1, .h = 1, .b2 = 1, .b3 = 1, .I1 = 0, .I2 = 0, .I3 = 0, .r1 = 1, .r2 = 1, .L = 1, .J = 1};
  const ModeTable table(p, {1, 10}, ForceKind::internal);
  const auto rejection = [&](const char* mode, const Rational& F) {
    for (const Rejection& r : motions_at(table, F).rejected) {
      if (r.mode == *parse_mode(mode)) return r;
    }
    FAIL("not rejected");
    return Rejection();
  };
  const Rejection gap = rejection("stick/lift", 2);
  REQUIRE(gap.violated);
  CHECK(name(*gap.violated) == "gap3 >= 0");
  CHECK(gap.margin < 0);
  CHECK(gap.solvable);
  CHECK(reason(gap) == "gap3 >= 0 is violated");
  const Rejection unsolvable = rejection("lift/stick", 2);
  CHECK_FALSE(unsolvable.solvable);
  CHECK_FALSE(unsolvable.violated);
  CHECK(reason(unsolvable) == "its equations have no solution");
  CHECK(rejection("lift/stick", 0).solvable);
}
