// The library as somebody calls it who has doubles: solve a scene, certify an answer, filter a batch.
#include <doctest/doctest.h>

#include <limits>

#include "base/number/parse.hpp"
#include "floating/filter/batch.hpp"
#include "mechanics/bicycle_modes/motions.hpp"
#include "records/certify/judge.hpp"

using namespace slipproof;

namespace {

const ForcedScene<double> typical{.bicycle = {.M = 94,
                                              .R = 0.3,
                                              .h = 0.56,
                                              .b2 = 0.34,
                                              .b3 = 0.68,
                                              .I1 = 0.01,
                                              .I2 = 0.12,
                                              .I3 = 0.2,
                                              .r1 = 0.09,
                                              .r2 = 0.036,
                                              .L = 0.17,
                                              .J = 15.7},
                                  .road = {.f = 0.8, .g = 9.81},
                                  .F = 300};

}  // namespace

TEST_CASE("a scene of doubles is solved exactly, and its answer certified") {
  const MotionsAtForce found = motions_at(typical);
  REQUIRE(found.motions.size() == 1);
  CHECK(found.motions[0].modes == std::vector{*parse_mode("stick/stick")});
  const Motion<Rational>& motion = found.motions[0].values;
  CHECK(motions_at(to_rational(typical)).motions[0].values == motion);
  const auto value = [&](Quantity q) { return motion[q].to_double(); };
  const SolverOutput right{.mode = parse_mode("stick/stick"),
                           .a = value(Quantity::a),
                           .S2 = value(Quantity::S2),
                           .S3 = value(Quantity::S3),
                           .N2 = value(Quantity::N2),
                           .N3 = value(Quantity::N3),
                           .eps3 = value(Quantity::eps3)};
  CHECK(judge(typical, right).verdict == RecordVerdict::certified);
  CHECK(judge(typical, right).tier == Tier::filter);
  CHECK(judge(to_rational(typical), right).verdict == RecordVerdict::certified);
  SolverOutput off = right;
  off.eps3 = *off.eps3 * 1.001;
  CHECK(judge(typical, off).verdict == RecordVerdict::inaccurate);
  CHECK(judge(typical, off, {.tolerance = 1e-2}).verdict == RecordVerdict::certified);
  off.mode = parse_mode("slip+/stick");
  CHECK(judge(typical, off).verdict == RecordVerdict::wrong);
  ForcedScene<double> broken = typical;
  broken.road.f = std::numeric_limits<double>::quiet_NaN();
  CHECK(judge(broken, right).verdict == RecordVerdict::invalid);
  CHECK_THROWS_AS(motions_at(broken), NumberError);
}

TEST_CASE("a continuum outlives the table that found it") {
  ForcedScene<double> massless = typical;
  massless.bicycle.I3 = 0;
  massless.F = 3000;
  const MotionsAtForce found = motions_at(massless);
  REQUIRE(found.continua.size() == 1);
  CHECK(name(found.continua[0].continuum->mode) == "stick/lift");
  CHECK(found.continua[0].continuum->parameters == std::vector{Quantity::eps3});
}

TEST_CASE("a batch is written down by names, numbers that are the same for all as numbers") {
  std::vector<double> forces, heights;
  for (int i = 0; i < 1000; ++i) {
    forces.push_back(-4000 + 8 * i);
    heights.push_back(0.4 + i * 1e-4);
  }
  const ForcedScene<Column> scenes{.bicycle = {.M = 94,
                                               .R = 0.3,
                                               .h = heights,
                                               .b2 = 0.34,
                                               .b3 = 0.68,
                                               .I1 = 0.01,
                                               .I2 = 0.12,
                                               .I3 = 0.2,
                                               .r1 = 0.09,
                                               .r2 = 0.036,
                                               .L = 0.17,
                                               .J = 15.7},
                                   .road = {.f = 0.8, .g = 9.81},
                                   .F = forces};
  const BatchAnswers answers = consistent_modes(scenes);
  REQUIRE(answers.modes.size() == forces.size());
  CHECK(answers.tiers[0] + answers.tiers[1] + answers.tiers[2] == forces.size());
  std::uint16_t seen = 0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    ForcedScene<double> one = typical;
    one.bicycle.h = heights[i];
    one.F = forces[i];
    CHECK(answers.modes[i] == consistent_modes(one));
    seen |= answers.modes[i].consistent;
  }
  CHECK(std::popcount(seen) > 3);
  // A number that is not given, or a column of another length, is told.
  ForcedScene<Column> incomplete = scenes;
  incomplete.bicycle.L = Column();
  CHECK_THROWS_AS(consistent_modes(incomplete), std::invalid_argument);
  heights.pop_back();
  incomplete = scenes;
  incomplete.bicycle.h = heights;
  CHECK_THROWS_AS(consistent_modes(incomplete), std::invalid_argument);
}
