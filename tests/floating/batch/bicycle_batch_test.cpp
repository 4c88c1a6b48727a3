// Many bicycles at once against their reduced equations, solved exactly.
#include "floating/batch/bicycle_batch.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>

#include "support/how_many.hpp"
#include "support/scenes/bicycle_populations.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

/// The numbers of bicycles, gathered.
struct Gathered {
  std::array<std::vector<double>, 15> numbers;
  std::vector<OracleModes> expected;

  void add(const ForcedScene<double>& s, const OracleModes& modes) {
    const Bicycle<double>& p = s.bicycle;
    const std::array<double, 15> all{
        p.M, p.R, p.h, p.b2, p.b3, p.I1, p.I2, p.I3, p.r1, p.r2, p.L, p.J.value_or(0), s.road.f, s.road.g, s.F};
    for (std::size_t i = 0; i < all.size(); ++i) numbers[i].push_back(all[i]);
    expected.push_back(modes);
  }

  BicycleColumns columns(bool with_J, ForceKind kind) const {
    BicycleColumns result;
    for (std::size_t i = 0; i < result.numbers.size(); ++i) result.numbers[i] = numbers[i];
    if (!with_J) result.numbers[11] = Column();
    result.F = numbers[14];
    result.external = kind == ForceKind::external;
    return result;
  }
};

BicycleColumns usual() {
  BicycleColumns bicycles{.numbers = {94, 0.3, 0.56, 0.34, 0.68, 0.01, 0.12, 0.2, 0.09, 0.036, 0.17, 15.7, 0.8, 9.81},
                          .F = 300};
  return bicycles;
}

}  // namespace

TEST_CASE("bicycles of every population have the modes of their reduced equations, at ends of intervals too") {
  RandomBicycles random(7);
  const std::size_t count = test::how_many<std::size_t>("SLIPPROOF_BATCH_BICYCLES", 25);
  std::array<Gathered, 4> groups;
  for (std::size_t i = 0; i < count; ++i) {
    for (int population = 0; population < population_count; ++population) {
      const ForcedScene<double> rounded = nearest_binary64(random.scene(Population{population}));
      const ForcedScene<Rational> scene = to_rational(rounded);
      const ForceOracle oracle(scene);
      auto& group = groups[(rounded.bicycle.J ? 1U : 0U) + (rounded.force_kind == ForceKind::external ? 2U : 0U)];
      for (const double F : random.forces(oracle, 20, population != 0)) {
        ForcedScene<double> at = rounded;
        at.F = F;
        group.add(at, oracle.at(F));
      }
    }
  }
  std::uint64_t by_filter = 0, all = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Gathered& group = groups[g];
    const BicycleColumns columns =
        group.columns((g & 1U) != 0, (g & 2U) != 0 ? ForceKind::external : ForceKind::internal);
    const BicycleModes found = consistent_modes(columns, 1);
    REQUIRE(found.consistent.size() == group.expected.size());
    std::size_t differences = 0;
    for (std::size_t i = 0; i < group.expected.size(); ++i) {
      const bool same =
          found.consistent[i] == group.expected[i].consistent && found.strict[i] == group.expected[i].strict;
      differences += same ? 0 : 1;
    }
    CHECK(differences == 0);
    CHECK(consistent_modes(columns, 3).consistent == found.consistent);
    by_filter += found.counts()[0];
    all += group.expected.size();
  }
  CHECK(by_filter * 4 > all);
  CHECK(by_filter < all);
}

TEST_CASE("numbers that are the same for all are numbers, and a batch is its bicycles one by one") {
  std::vector<double> forces, heights;
  for (int i = 0; i < 1000; ++i) {
    forces.push_back(-4000 + 8 * i);
    heights.push_back(0.4 + i * 1e-4);
  }
  BicycleColumns bicycles = usual();
  bicycles.numbers[2] = heights;
  bicycles.F = forces;
  const BicycleModes found = consistent_modes(bicycles);
  REQUIRE(found.consistent.size() == forces.size());
  unsigned seen = 0;
  for (std::size_t i = 0; i < forces.size(); i += 7) {
    BicycleColumns one = usual();
    one.numbers[2] = heights[i];
    one.F = forces[i];
    CHECK(consistent_modes(one).consistent.at(0) == found.consistent[i]);
    seen |= found.consistent[i];
  }
  CHECK(std::popcount(seen) > 3);
}

TEST_CASE("a missing number, a column of another length and a bicycle outside the domain are told") {
  BicycleColumns bicycles = usual();
  bicycles.numbers[10] = Column();
  CHECK_THROWS_WITH_AS(consistent_modes(bicycles), doctest::Contains("L: found no number"), std::invalid_argument);
  bicycles = usual();
  const std::vector<double> two{1, 2}, three{1, 2, 3};
  bicycles.numbers[0] = two;
  bicycles.F = three;
  CHECK_THROWS_AS(consistent_modes(bicycles), std::invalid_argument);
  bicycles = usual();
  const std::vector<double> radii{0.3, -1, 0.3};
  bicycles.numbers[1] = radii;
  CHECK_THROWS_WITH_AS(consistent_modes(bicycles), doctest::Contains("bicycle 2: R: found -1, expected R > 0"),
                       std::invalid_argument);
  const std::vector<double> heights{0.5, std::nan("")};
  bicycles = usual();
  bicycles.numbers[2] = heights;
  CHECK_THROWS_WITH_AS(consistent_modes(bicycles), doctest::Contains("bicycle 2: h: found NaN"), std::invalid_argument);
}
