// The batch of any mechanism beside the exact kernel: never another answer, and seldom none.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/number/binary64.hpp"
#include "base/number/dice.hpp"
#include "floating/batch/mechanism_batch.hpp"
#include "floating/tape/mode_run.hpp"
#include "mechanics/kernel/mode_solver.hpp"
#include "mechanics/points/degrees.hpp"
#include "mechanics/points/sampling.hpp"
#include "mechanics/reading/shipped.hpp"
#include "mechanics/scene/scene.hpp"
#include "support/how_many.hpp"

using namespace slipproof;

namespace {

std::size_t load_count() {
  return test::how_many<std::size_t>("SLIPPROOF_RANDOM_LOADS", 2500);
}

double between(Dice& dice, double low, double high) {
  return low + (high - low) * dice.number(0, 1'000'000'000) * 1e-9;
}

/// A point of a mechanism in binary64; the same exactly.
struct DoublePoint {
  std::vector<double> parameters, tan_halves;
  MechanismValues values;
};

/// Small numbers, zeros among them, or their neighbours, or numbers of very different sizes.
double spread(double x, int kind, Dice& dice) {
  if (kind != 0 && x == 0) x = 0.01;
  if (kind == 1) return x * between(dice, 0.9, 1.1);
  if (kind == 2) return std::ldexp(x * between(dice, 0.5, 1), dice.number(-40, 40));
  return x;
}

DoublePoint double_point(const Mechanism& mechanism, const MechanismValues& sample, int kind, Dice& dice) {
  DoublePoint point{{}, {}, default_values(mechanism)};
  for (std::size_t i = 0; i < sample.parameters.size(); ++i) {
    point.parameters.push_back(spread(nearest_binary64(sample.parameters[i]), kind, dice));
    point.values.parameters[i] = to_rational(point.parameters.back());
  }
  for (std::size_t i = 0; i < sample.angles.size(); ++i) {
    const auto& at = sample.angles[i];
    const double t = at.cosine == -1 ? 1e9 : nearest_binary64(Rational(at.sine / (1 + at.cosine)));
    point.tan_halves.push_back(kind == 1 ? t * between(dice, 0.9, 1.1) : t);
    point.values.angles[i] = point_of_tan_half(to_rational(point.tan_halves.back()));
  }
  return point;
}

void add_end(std::vector<double>& loads, const std::optional<Rational>& end) {
  if (!end) return;
  const double x = nearest_binary64(*end);
  if (!std::isfinite(x)) return;
  loads.insert(loads.end(), {x, std::nextafter(x, HUGE_VAL), std::nextafter(x, -HUGE_VAL), x * (1 + 1e-13)});
}

/// Ends of ranges, their neighbours, 0, and random ones of the size of the ends.
std::vector<double> loads_for(const std::vector<ConsistentMode>& modes, std::size_t count, Dice& dice) {
  std::vector<double> loads{0, -0.0, 1, 0x1p40, -0x1p-40};
  for (const ConsistentMode& mode : modes) {
    add_end(loads, mode.solutions.loads.lower());
    add_end(loads, mode.solutions.loads.upper());
  }
  const std::size_t ends = loads.size();
  while (loads.size() < ends + count) {
    double size = loads[static_cast<std::size_t>(dice.number(0, static_cast<int>(ends) - 1))];
    if (size == 0) size = 1;
    loads.push_back(size * between(dice, -2, 2) + (dice.chance(4) ? between(dice, -10, 10) : 0));
  }
  return loads;
}

struct Tally {
  std::size_t points = 0, different = 0, by_filter = 0;  ///< points: those that were decided

  void add(const Tally& other) {
    points += other.points;
    different += other.different;
    by_filter += other.by_filter;
  }
};

/// All loads of one point: the kernel knows each mode's loads at once.
void compare(const MechanismBatch& batch, const Mechanism& mechanism, const ProblemMaker& maker,
             const DoublePoint& point, std::size_t count, Unsure unsure, Dice& dice, Tally& tally) {
  FrictionProblem problem = without_equations(maker.problem(point.values));
  problem.load_domain = ForceInterval();
  const std::vector<ConsistentMode> consistent = modes_of(problem, std::nullopt).consistent;
  std::vector<const ConsistentMode*> by_mode(batch.modes().size(), nullptr);
  std::vector<ForceInterval> strict(by_mode.size(), ForceInterval::nothing());
  for (const ConsistentMode& found : consistent) {
    const auto place = std::find(batch.modes().begin(), batch.modes().end(), found.mode) - batch.modes().begin();
    by_mode[static_cast<std::size_t>(place)] = &found;
    strict[static_cast<std::size_t>(place)] = strict_loads(found.solutions);
  }
  const std::vector<double> loads = loads_for(consistent, mechanism.load ? count : 1, dice);
  MechanismColumns columns{
      {point.parameters.begin(), point.parameters.end()}, {point.tan_halves.begin(), point.tan_halves.end()}, {}};
  if (mechanism.load) columns.load = Column(loads);
  const MechanismAnswers answers = batch.modes_at(columns, unsure);
  const std::size_t points = answers.status.size() / answers.modes;
  for (std::size_t i = 0; i < points; ++i) {
    if (answers.at(i, 0) == ModeAt::unsure) continue;
    ++tally.points;
    const Rational load = mechanism.load ? to_rational(loads[i]) : Rational(0);
    for (std::size_t k = 0; k < by_mode.size(); ++k) {
      const ModeAt expected =
          by_mode[k] == nullptr || !by_mode[k]->solutions.loads.contains(load)         ? ModeAt::inconsistent
          : (mechanism.load ? strict[k].contains(load) : by_mode[k]->solutions.strict) ? ModeAt::strict
                                                                                       : ModeAt::boundary;
      tally.different += answers.at(i, k) == expected ? 0 : 1;
    }
  }
  tally.by_filter += answers.tiers[static_cast<std::size_t>(Tier::filter)];
}

}  // namespace

TEST_CASE("batches of every shipped mechanism have the kernel's modes at random loads and at the ends of ranges") {
  const std::size_t per_mechanism = load_count() / shipped_mechanisms().size() + 1;
  Tally plain;  // of usual numbers
  for (const ShippedMechanism& shipped : shipped_mechanisms()) {
    CAPTURE(shipped.name);
    const Mechanism mechanism = open_mechanism(std::string(shipped.name));
    const MechanismBatch batch(mechanism);
    REQUIRE(batch.code() != nullptr);
    const ProblemMaker maker(mechanism);
    // Of many loads only those that the filter decides: what it passes on would be the kernel against itself.
    const bool many = per_mechanism > 10'000;
    const std::size_t loads = many ? 5000 : 60;
    Tally all;
    for (std::uint64_t round = 0; all.points < per_mechanism; ++round) {
      Dice dice(71, round);
      for (const MechanismValues& sample : sample_values(mechanism, maker, 6, 100 + round)) {
        const int kind = dice.number(0, 2);
        Tally tally;
        const DoublePoint point = double_point(mechanism, sample, kind, dice);
        compare(batch, mechanism, maker, point, kind == 0 ? 60 : loads, many ? Unsure::left : Unsure::decided, dice,
                tally);
        all.add(tally);
        if (kind == 1 && maker.broken(point.values).empty()) plain.add(tally);
        if (all.points >= per_mechanism) break;
      }
    }
    CHECK(all.different == 0);
    MESSAGE(std::string(shipped.name) << ": " << all.points << " points, " << all.by_filter << " without the kernel");
  }
  CHECK(plain.by_filter * 2 >= plain.points);
}

TEST_CASE("bodies at rest on two contacts need no kernel") {
  for (const char* name : {"ladder", "block-shaken", "gripper", "trailer"}) {
    CAPTURE(name);
    const Mechanism mechanism = open_mechanism(name);
    const MechanismScene scene =
        read_scene(std::string(SLIPPROOF_SOURCE_DIR) + "/cases/mechanisms/scenes/" + name + ".toml");
    std::vector<double> parameters, halves;
    for (const Rational& x : scene.values.parameters) parameters.push_back(nearest_binary64(x));
    for (const auto& at : scene.values.angles) halves.push_back(nearest_binary64(Rational(at.sine / (1 + at.cosine))));
    const MechanismBatch batch(mechanism);
    const double load = nearest_binary64(scene.load.value_or(1)) * 1.001;
    const MechanismAnswers answers =
        batch.modes_at({{parameters.begin(), parameters.end()}, {halves.begin(), halves.end()}, Column(load)});
    CHECK(answers.tiers[static_cast<std::size_t>(Tier::filter)] == 1);
  }
}

TEST_CASE("points together have the modes and the tiers that each has alone") {
  std::size_t by_filter = 0;
  for (const char* name : {"bicycle", "block-on-incline", "painleve-rod", "stacked-blocks"}) {
    CAPTURE(name);
    const Mechanism mechanism = open_mechanism(name);
    const MechanismBatch batch(mechanism);
    const MechanismValues sample = sample_values(mechanism, ProblemMaker(mechanism), 1, 3).front();
    // Beside the sample, and a few of another size: those are outside of the ranges that the others share.
    constexpr std::size_t count = 700;
    std::vector<std::vector<double>> parameters(sample.parameters.size()), halves(sample.angles.size());
    std::vector<double> loads;
    Dice dice(17, 1);
    for (std::size_t i = 0; i < count; ++i) {
      const DoublePoint point = double_point(mechanism, sample, i % 90 == 89 ? 2 : 0, dice);
      for (std::size_t k = 0; k < parameters.size(); ++k) {
        parameters[k].push_back(point.parameters[k] * (k % 3 == 0 ? between(dice, 0.97, 1.03) : 1));
      }
      for (std::size_t k = 0; k < halves.size(); ++k) halves[k].push_back(point.tan_halves[k]);
      loads.push_back(between(dice, -20, 20));
    }
    const auto columns = [&](std::size_t first, std::size_t size) {
      const auto part = [&](const std::vector<double>& all) { return Column(std::span(all).subspan(first, size)); };
      MechanismColumns result;
      for (const auto& column : parameters) result.parameters.push_back(part(column));
      for (const auto& column : halves) result.tan_halves.push_back(part(column));
      if (mechanism.load) result.load = part(loads);
      return result;
    };
    const MechanismAnswers together = batch.modes_at(columns(0, count));
    TierCounts alone{};
    std::size_t different = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const MechanismAnswers one = batch.modes_at(columns(i, 1));
      for (std::size_t mode = 0; mode < one.modes; ++mode) different += one.at(0, mode) == together.at(i, mode) ? 0 : 1;
      for (std::size_t tier = 0; tier < tier_count; ++tier) alone[tier] += one.tiers[tier];
    }
    CHECK(different == 0);
    CHECK(together.tiers == alone);
    by_filter += together.tiers[static_cast<std::size_t>(Tier::filter)];
  }
  CHECK(by_filter > 1400);
}

TEST_CASE("running errors enclose what is exact, whatever the sizes") {
  Dice dice(5, 1);
  const auto number = [&](int most) {
    const double x = std::ldexp(between(dice, -1, 1), dice.number(-most, most));
    return dice.chance(20) ? 0.0 : x;
  };
  const auto encloses = [](const RunningError& x, const Rational& exact) {
    if (!(std::isfinite(x.value[0]) && std::isfinite(x.error[0]))) return true;
    return abs(Rational(to_rational(x.value[0]) - exact)) <= to_rational(x.error[0]);
  };
  for (int i = 0; i < 20'000; ++i) {
    const int most = i % 4 == 0 ? 1000 : i % 4 == 1 ? 300 : 20;
    RunningError x{Lanes{} + number(most), Lanes{} + (dice.chance(2) ? 0 : std::fabs(number(most)) * 1e-3)};
    RunningError y{Lanes{} + number(most), Lanes{} + (dice.chance(2) ? 0 : std::fabs(number(most)) * 1e-3)};
    // Somewhere in the enclosures, ends included.
    const Rational a = to_rational(x.value[0]) + to_rational(x.error[0]) * dice.number(-2, 2) / 2;
    const Rational b = to_rational(y.value[0]) + to_rational(y.error[0]) * dice.number(-2, 2) / 2;
    CHECK(encloses(x + y, a + b));
    CHECK(encloses(x - y, a - b));
    CHECK(encloses(x * y, a * b));
    if (!b.is_zero()) CHECK(encloses(x / y, a / b));
    if (surely_positive(x)[0] != 0) CHECK(a > 0);
    if (surely_negative(x)[0] != 0) CHECK(a < 0);
    if (surely_zero(x)[0] != 0) CHECK(a == 0);
  }
}

TEST_CASE("nothing is sure of what is not finite") {
  for (const double x : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    const RunningError bad{Lanes{} + x, Lanes{}}, worse{Lanes{} + x, Lanes{} + HUGE_VAL};
    const RunningError one{Lanes{} + 1, Lanes{}}, zero{};
    for (const RunningError& r : {worse, bad + bad, bad - bad, bad * zero, zero / zero, one / zero, one / bad}) {
      CHECK(surely_positive(r)[0] == 0);
      CHECK(surely_negative(r)[0] == 0);
      CHECK(surely_not_negative(r)[0] == 0);
      CHECK(surely_zero(r)[0] == 0);
    }
  }
}
