// The filter never says what the exact solver does not. The long version is tests/floating/filter_soak.
#include <doctest/doctest.h>

#include "floating/filter/batch.hpp"
#include "floating/filter/lanes.hpp"
#include "mechanics/bicycle/conditions.hpp"
#include "support/filter_scenes.hpp"

using namespace slipproof;
using namespace slipproof::test;

TEST_CASE("whatever a tier decides is what the exact solver says, near thresholds and at the extremes") {
  FilterScenes random(61);
  for (int population = 0; population < population_count; ++population) {
    for (const bool adversarial : {false, true}) {
      Comparison found;
      BatchComparison batch;
      const auto kind = static_cast<Population>(population);
      for (int i = 0; i < 20; ++i) compare(random, kind, 100, adversarial, found, batch);
      for (int i = 0; i < 500; ++i) compare(random, kind, 1, adversarial, found, batch);
      batch.run(1 + static_cast<unsigned>(population) % 2, found);
      CAPTURE(population);
      CAPTURE(adversarial);
      CHECK(found.scenes == 2500);
      CHECK(found.differences == 0);
      CHECK(found.bicycles == 520);
      CHECK((kind == Population::fractions ? found.in_batches == 0 : found.in_batches > 300));
      if (population == 0 && !adversarial) CHECK(found.undecided <= 50);  // forces of 0 and below 1e-290
      if (adversarial) CHECK(found.undecided > 0);                        // the ties are there
      CHECK(found.undecided_twice <= found.undecided);
    }
  }
}

TEST_CASE("each tier is reached, and the answer of all tiers together is the exact one, boundaries included") {
  FilterScenes random(62);
  TierCounts counts{};
  for (int i = 0; i < 200; ++i) {
    ForcedScene<Rational> s = random.scene(static_cast<Population>(i % population_count));
    const ForceOracle oracle(s);
    for (const double F : random.forces(oracle, 4, true)) {
      s.F = to_rational(F);
      const ConsistentModes answer = consistent_modes(s), exact = oracle.at(F);
      CHECK(answer.consistent == exact.consistent);
      CHECK(answer.strict == exact.strict);
      ++counts[static_cast<std::size_t>(answer.tier)];
    }
  }
  for (const auto count : counts) CHECK(count > 0);
}

TEST_CASE(
    "a distance of 2^-40 from a threshold is decided by the first tier, 2^-80 by the second, 0 by the exact one") {
  FilterScenes random(63);
  int first = 0, second = 0, exact = 0, all = 0;
  for (int i = 0; i < 100; ++i) {
    ForcedScene<Rational> s = random.scene(Population::bicycles);
    const ModeTable table(s.bicycle, s.road, s.force_kind);
    for (const ModeSolution& mode : table.solutions()) {
      if (!mode.closed().lower() || mode.closed().is_point() || sign(*mode.closed().lower()) == 0) continue;
      const Rational end = *mode.closed().lower();
      const auto tier_at = [&](int k) {
        s.F = end + (k == 0 ? Rational(0) : abs(end) / Rational(Integer(1) << k));
        const ConsistentModes answer = consistent_modes(s);
        CHECK(((answer.consistent >> mode.mode().index()) & 1) == mode.closed().contains(s.F));
        return answer.tier;
      };
      ++all;
      first += tier_at(40) == Tier::filter;
      second += tier_at(80) == Tier::double_double;
      exact += tier_at(0) == Tier::exact;
    }
  }
  REQUIRE(all > 300);
  CHECK(first > all * 99 / 100);
  CHECK(second > all * 99 / 100);
  CHECK(exact == all);
}

TEST_CASE(
    "a batch gives what its scenes give one by one, at any number of threads, tails and shared columns included") {
  FilterScenes random(64);
  for (const std::size_t count : {1U, 7U, 8U, 1700U}) {
    SceneColumns columns;
    std::vector<ForcedScene<double>> scenes;
    while (scenes.size() < count) {
      const auto s = random.scene(static_cast<Population>(random.next() % population_count));
      if (!s.bicycle.J || s.force_kind != ForceKind::internal) continue;
      const ForceOracle oracle(s);
      for (const double F : random.forces(oracle, 50, true)) {
        scenes.push_back(nearest_binary64(s));
        scenes.back().F = F;
        columns.add(scenes.back());
        if (scenes.size() == count) break;
      }
    }
    const ForcedScene<Column> batch = columns.scenes();
    std::vector<ConsistentModes> one(count), many(count);
    TierCounts counts{}, counts_many{};
    consistent_modes(batch, one, counts);
    consistent_modes(batch, many, counts_many, 2);
    CHECK(one == many);
    CHECK(consistent_modes(batch).modes == one);
    CHECK(counts == counts_many);
    for (const Registers registers : {Registers::two, Registers::four, Registers::eight}) {
      if (!available(registers)) continue;
      TierCounts counts_here{};
      std::vector<ConsistentModes> here(count);
      consistent_modes(batch, here, counts_here, 1, registers);
      CHECK(here == one);
      CHECK(counts_here == counts);
    }
    CHECK(counts[0] + counts[1] + counts[2] == count);
    for (std::size_t k = 0; k < count; ++k) CHECK(one[k] == consistent_modes(scenes[k]));

    ForcedScene<Column> shared = batch;  // one bicycle, many forces
    Bicycle<Column>& p = shared.bicycle;
    for (Column* c : {&p.M, &p.R, &p.h, &p.b2, &p.b3, &p.I1, &p.I2, &p.I3, &p.r1, &p.r2, &p.L}) *c = (*c)[0];
    p.J.reset();
    consistent_modes(shared, many, counts_many);
    for (std::size_t k = 0; k < count; ++k) {
      ForcedScene<double> s = scenes[0];
      s.bicycle.J.reset();
      s.road = scenes[k].road;
      s.F = scenes[k].F;
      CHECK(many[k] == consistent_modes(s));
    }
  }
  std::vector<ConsistentModes> none(3);
  TierCounts counts{};
  CHECK_THROWS_AS(consistent_modes(ForcedScene<Column>{}, none, counts), std::invalid_argument);
}

TEST_CASE("the guard against underflow matters: without it a sign is wrong") {
  // 2^-600 2^-600 underflows to 0 = its own magnitude: an unguarded bound calls the difference -2^-1100 exact.
  const Tracked x = Tracked::input(0x1p-600), y = Tracked::input(0x1p-550);
  const Tracked difference = x * x - y * Tracked::input(0x1p-520) * Tracked::input(0x1p-30);
  CHECK(!certainly_positive(difference));
  CHECK(!certainly_negative(difference));
  const Tracked product = x * x * Tracked::input(0x1p600) + Tracked::input(-0x1p-700);
  CHECK(!certainly_positive(product));  // exactly 2^-600 - 2^-700 > 0
  CHECK(!certainly_negative(product));
  const double unguarded = product.magnitude() * error_roundings * unit_roundoff;
  CHECK(product.value() < -unguarded);  // "certainly negative", were it not for underflow_error
}

TEST_CASE("both signs at once are certain exactly where each comparison is, to the last bit") {
  const double bound = error_roundings * unit_roundoff;
  for (const double value : {0.0, -0.0, 1.0, 0x1p-388, 0x1p-387, 0x1p-386, 0x1p300}) {
    for (const double size : {0.0, value, value / bound, std::nextafter(value / bound, 0.0),
                              std::nextafter(value / bound, HUGE_VAL), value / bound / 2, 2 * value / bound}) {
      // The value, and a magnitude of about `size`.
      const Tracked padding = Tracked::input(size / 2) - Tracked::input(size / 2);
      for (const Tracked x : {Tracked::input(value) + padding, Tracked::input(-value) + padding}) {
        CAPTURE(value);
        CAPTURE(size);
        CHECK(certain_sign(x) == (certainly_positive(x) ? 1 : certainly_negative(x) ? 2 : 0));
      }
    }
  }
}

TEST_CASE("inputs that are no numbers or too large are never decided by the fast tiers") {
  FilterScenes random(65);
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e300, 2 * input_limit}) {
    for (int k = 0; k < 15; ++k) {
      auto s = random.scene(Population::bicycles);
      s.bicycle.J = 1;
      int i = 0;
      const auto spoiled = convert<double, double>(nearest_binary64(s), [&](double x) { return i++ == k ? bad : x; });
      CHECK(filter_modes(spoiled).undecided == 0xFFFF);
      CHECK(double_double_modes(spoiled).undecided == 0xFFFF);
    }
  }
}

ForcedScene<LaneNumbers> in_all_lanes(const ForcedScene<double>& s) {
  return convert<double, LaneNumbers>(s, [](double x) {
    LaneNumbers numbers;
    numbers.of.fill(x);
    return numbers;
  });
}

TEST_CASE("the lanes of a batch decide for themselves what the first tier decides, with its magnitudes") {
  CHECK(TrackedLanes<Lanes>::input(Lanes{} - 3).magnitude[0] == 3);
  FilterScenes random(66);
  std::array<ModeSets, lane_count> sets;
  for (int i = 0; i < 500; ++i) {
    auto s = nearest_binary64(random.scene(i % 2 == 0 ? Population::bicycles : Population::wide));
    s.F = random.signed_log(1, 3000);
    filter_lanes(in_all_lanes(s), sets);
    const ModeSets one = filter_modes(s);
    const ModeSets& lane = sets[static_cast<std::size_t>(i % lane_count)];
    CHECK((lane.undecided != 0) == (one.undecided != 0));
    if (one.undecided == 0) CHECK(lane.consistent == one.consistent);
  }
}

TEST_CASE("scenes that share their bounds are decided by them where they are alike, and by their own where not") {
  FilterScenes random(68);
  SceneColumns columns;
  std::vector<ForcedScene<double>> scenes;
  const auto add = [&](ForcedScene<double> s) {
    if (!s.bicycle.J) s.bicycle.J = 10;
    s.force_kind = ForceKind::internal;
    if (random.next() % 3 == 0) s.F = std::nextafter(s.F, 0);
    columns.add(s);
    scenes.push_back(s);
  };
  for (int i = 0; i < 600; ++i) add(random.typical());
  for (int i = 0; i < 600; ++i) {  // a number larger than all before, infinite or none, among the others
    auto s = random.typical();
    int at = 0;
    const int changed = static_cast<int>(random.next() % 15);
    const double factor = std::array{1e3, 1e11, HUGE_VAL, std::nan(""), -5.0}[random.next() % 5];
    if (i % 7 == 0) s = convert<double, double>(s, [&](double x) { return at++ == changed ? x * factor : x; });
    if (std::isfinite(factor)) add(s);
  }
  for (int i = 0; i < 600; ++i) {  // every number of another size
    auto s = nearest_binary64(random.scene(Population::wide));
    s.F = random.signed_log(1, 3000);
    add(s);
  }
  for (int i = 0; i < 700; ++i) {  // light ones, whose bounds would let thresholds of others pass
    auto s = random.typical();
    s.bicycle.J = 10;
    Bicycle<double>& p = s.bicycle;
    for (double* mass : {&p.M, &p.I1, &p.I2, &p.I3, &*p.J, &s.F}) *mass = std::ldexp(*mass, -16);
    add(s);
  }
  while (scenes.size() < 3000) {
    auto s = random.scene(Population::bicycles);
    s.bicycle.J = 10;
    s.force_kind = ForceKind::internal;
    for (const double F : random.forces(ForceOracle(s), 20, true)) {
      auto rounded = nearest_binary64(s);
      rounded.F = F;
      add(rounded);
    }
  }
  TierCounts counts{};
  std::vector<ConsistentModes> answers(scenes.size());
  consistent_modes(columns.scenes(), answers, counts);
  for (std::size_t i = 0; i < scenes.size(); ++i) CHECK(answers[i] == consistent_modes(scenes[i]));

  // The bounds of a scene that is larger than all are larger than any's.
  for (std::size_t i = 0; i + 8 < scenes.size(); i += 8) {
    const ForcedScene<double>& s = scenes[i];
    int at = 0;
    const auto larger = convert<double, double>(s, [&](double x) { return x * (++at % 3 == 0 ? 1 : 1 + 0.01 * at); });
    const SharedBounds own(tracked_dynamics<Magnitude>(s), true), shared(tracked_dynamics<Magnitude>(larger), true);
    CHECK(own.A <= shared.A);
    for (const ContactMode mode : all_modes()) {
      const auto dynamics = tracked_dynamics<Tracked>(s);
      const ReducedMotion<Tracked, Tracked> motion(dynamics, mode);
      CHECK(motion.determinant().error() <= own.modes[mode.index()]);
      CHECK(own.modes[mode.index()] <= shared.modes[mode.index()]);
      for (const Condition& c : conditions(mode)) {
        CHECK(motion.condition_value(c).numerator.error() <= own.modes[mode.index()]);
      }
    }
  }
}

TEST_CASE("a wheel that may have no inertia leaves its slipping modes undecided, one by one and in lanes") {
  FilterScenes random(67);
  for (int i = 0; i < 100; ++i) {
    auto s = nearest_binary64(random.scene(Population::bicycles));
    const bool rear = i % 3 != 0, front = i % 3 != 1;
    if (rear) s.bicycle.I1 = s.bicycle.I2 = 0;
    if (front) s.bicycle.I3 = 0;
    s.F = random.signed_log(1, 3000);
    unsigned free = 0;
    for (const ContactMode mode : all_modes()) {
      if (!mode.on_road() && !s.bicycle.J) continue;
      if ((rear && mode.rear != ContactState::stick) || (front && mode.front != ContactState::stick)) {
        free |= 1U << mode.index();
      }
    }
    CHECK((filter_modes(s).undecided & free) == free);
    CHECK((double_double_modes(s).undecided & free) == free);
    std::array<ModeSets, lane_count> sets;
    filter_lanes(in_all_lanes(s), sets);
    CHECK((sets[static_cast<std::size_t>(i % lane_count)].undecided != 0) == (free != 0));
    const ConsistentModes all = consistent_modes(s), exact = exact_modes(to_rational(s));
    CHECK(all.consistent == exact.consistent);
    CHECK(all.strict == exact.strict);
  }
}

TEST_CASE("a double-double product underflows in several places, and in no more than its bound has room for") {
  FilterScenes random(68);
  Rational worst = 0;
  for (int i = 0; i < 100000; ++i) {
    const auto draw = [&](int exponent) {
      const double high = std::ldexp(random.uniform(1, 2), exponent);
      return DoubleDouble{high, high * random.uniform(-1, 1) * 0x1p-54};
    };
    const int exponent = -static_cast<int>(random.next() % 60);
    const DoubleDouble x = draw(exponent - 480), y = draw(-540 - exponent), p = x * y;
    const auto value = [](DoubleDouble z) { return Rational(to_rational(z.high) + to_rational(z.low)); };
    const Rational exact = value(x) * value(y), unit = to_rational(0x1p-1074) / 2;
    const Rational relative = exact * to_rational(double_double_roundoff);
    worst = std::max(worst, Rational((abs(value(p) - exact) - relative) / unit));
  }
  // A product of binary64 counts as two units.
  CHECK(worst > 2);
  CHECK(worst <= to_rational(2 * double_double_underflow_error / underflow_error));
  MESSAGE("underflow of a double-double product, in units: " << nearest_binary64(worst));
}
