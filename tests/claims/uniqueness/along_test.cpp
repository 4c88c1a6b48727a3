// Along the coefficient of friction: what is said of a range is so at every number in it, by the table of modes.
#include "claims/uniqueness/along.hpp"

#include <doctest/doctest.h>

#include "claims/uniqueness/ranges.hpp"
#include "mechanics/kernel/mode_solver.hpp"
#include "support/bicycle/mode_table.hpp"
#include "support/bicycle/motions.hpp"
#include "support/scenes/bicycle_scenes.hpp"
#include "support/scenes/random_scene.hpp"

using namespace slipproof;

namespace {

/// The numbers of motions over all forces, from below, neighbours that are alike joined; a continuum counts as -1.
std::vector<int> counts(const BicycleOfValues& scene, const Rational& f) {
  const ModeTable table(scene.bicycle, {f, scene.road.g}, scene.kind);
  std::vector<int> result;
  for (const Cell& cell : partition(table)) {
    const int count = cell.continua.empty() ? static_cast<int>(cell.motions.size()) : -1;
    if (result.empty() || result.back() != count) result.push_back(count);
  }
  return result;
}

std::vector<int> counts(const MotionsAtParameter& motions) {
  std::vector<int> result;
  std::optional<ForceInterval> last;
  for (const LoadsApart& a : motions.apart) {
    const bool adjacent =
        last && last->upper() && a.loads.lower() == last->upper() && (last->upper_closed() || a.loads.lower_closed());
    if (!adjacent && !(result.empty() && !a.loads.lower())) result.push_back(1);
    result.push_back(a.continuum ? -1 : static_cast<int>(a.motions));
    last = a.loads;
  }
  if (!last || last->upper()) result.push_back(1);
  return result;
}

/// What is said of every q at a coefficient, without the size of the determinant.
void check_every_q(const MechanismScene& scene, const Rational& f, const MotionsAtParameter& said) {
  MechanismValues values = scene.values;
  values.parameters[12] = f;
  REQUIRE(scene.mechanism.parameters[12].symbol == "f");
  const auto problem = contact_problem(without_equations(friction_problem(scene.mechanism, values)));
  REQUIRE(problem.has_value() == said.for_every_q.has_value());
  if (!problem) return;
  const EveryLoad there = for_every_load(*problem);
  CHECK(there.verdict == said.for_every_q->verdict);
  CHECK(there.mode == said.for_every_q->mode);
  CHECK(there.determinant.sign() == said.for_every_q->determinant.sign());
}

}  // namespace

TEST_CASE("ranges of friction say what the table of modes finds at numbers in them") {
  test::RandomScenes random(233);
  int ambiguous = 0;
  for (int i = 0; i < 12; ++i) {
    BicycleOfValues scene;
    scene.bicycle = i % 2 == 0 ? random.bicycle(true) : random.reduced(true);
    scene.road = random.road();
    scene.kind = i % 3 == 0 ? ForceKind::external : ForceKind::internal;
    const MechanismScene of_mechanism = test::scene_of(scene.bicycle, scene.road, scene.kind);
    const UniquenessAlong along = uniqueness_along(of_mechanism, "f");
    CHECK(along.own == scene.road.f);
    CHECK(counts(along.at_own) == counts(scene, scene.road.f));
    const auto all = ranges(along);
    REQUIRE_FALSE(all.empty());
    CHECK(all.front().lower->lower == 0);
    CHECK_FALSE(all.back().upper);
    for (const ParameterRange& range : all) {
      if (!range.motions.apart.empty()) ++ambiguous;
      CAPTURE(range.sample);
      CHECK(counts(scene, range.sample) == counts(range.motions));
      check_every_q(of_mechanism, range.sample, range.motions);
      if (!range.upper || !range.lower || range.lower->lower == range.upper->upper) continue;
      for (int k = 1; k < 4; ++k) {
        const Rational f = range.lower->upper + (range.upper->lower - range.lower->upper) * Rational(k, 4);
        CHECK(counts(scene, f) == counts(range.motions));
        check_every_q(of_mechanism, f, range.motions);
      }
    }
  }
  CHECK(ambiguous > 5);
}

TEST_CASE("the ambiguous bicycle of the paper: from f = 21/25 on, a continuum there and then three motions") {
  const MechanismScene scene = read_scene(SLIPPROOF_SOURCE_DIR "/cases/ambiguous.toml");
  const UniquenessAlong along = uniqueness_along(scene, "f");
  REQUIRE(along.first_apart());
  CHECK(along.first_apart()->lower == Rational(21, 25));
  const auto all = ranges(along);
  REQUIRE(all.size() == 5);
  CHECK(all[0].motions.for_every_q->verdict == EveryLoad::Verdict::unique);
  CHECK(all[0].unseen.empty());
  CHECK(all[0].upper->lower == Rational(2, 5));
  CHECK(all[1].upper->lower == Rational(2, 5));  // the determinant is 0 there only
  CHECK(all[1].motions.for_every_q->determinant.is_zero());
  CHECK(all[2].motions.apart.empty());
  CHECK(all[2].motions.for_every_q->verdict == EveryLoad::Verdict::not_unique);
  CHECK(all[2].motions.for_every_q->determinant < 0);
  REQUIRE(all[3].motions.apart.size() == 1);
  CHECK(all[3].motions.apart.front().continuum);
  REQUIRE(all[4].motions.apart.size() == 3);
  CHECK(all[4].motions.apart[1].motions == 3);
}

TEST_CASE("what is no parameter of the scene is refused") {
  const MechanismScene scene = read_scene(SLIPPROOF_SOURCE_DIR "/cases/ambiguous.toml");
  CHECK_THROWS_WITH_AS(uniqueness_along(scene, "ff"), doctest::Contains("ff"), std::invalid_argument);
}

TEST_CASE("a collar on two guides has 36 modes, which are followed along its friction") {
  const auto scene = read_scene(SLIPPROOF_SOURCE_DIR "/tests/claims/uniqueness/collar-scene.toml");
  const UniquenessAlong found = uniqueness_along(scene, "mu");
  CHECK(found.at_own.apart.empty());
  CHECK_FALSE(found.cells.empty());
}
