// Points that share their error bounds: nothing that the exact kernel does not say, and not nothing.
#include "floating/batch/block_modes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/number/binary64.hpp"
#include "base/number/dice.hpp"
#include "floating/batch/mechanism_batch.hpp"
#include "floating/tape/mode_code.hpp"
#include "mechanics/kernel/mode_solver.hpp"
#include "mechanics/points/problem.hpp"
#include "mechanics/reading/shipped.hpp"

using namespace slipproof;

namespace {

/// A bicycle by the symbols of its mechanism, its load too.
using Numbers = std::map<std::string, double>;

double uniform(Dice& dice, double low, double high) {
  return low + (high - low) * dice.number(0, 1'000'000'000) * 1e-9;
}

Numbers usual(Dice& dice) {
  return {{"M", uniform(dice, 50, 150)},     {"R", uniform(dice, 0.2, 0.4)},   {"h", uniform(dice, -0.1, 0.9)},
          {"b2", uniform(dice, 0.3, 0.8)},   {"b3", uniform(dice, 0.3, 0.8)},  {"I1", uniform(dice, 0.002, 0.03)},
          {"I2", uniform(dice, 0.05, 0.3)},  {"I3", uniform(dice, 0.05, 0.3)}, {"r1", uniform(dice, 0.05, 0.12)},
          {"r2", uniform(dice, 0.02, 0.12)}, {"L", uniform(dice, 0.14, 0.2)},  {"J", uniform(dice, 5, 30)},
          {"f", uniform(dice, 0.05, 1.5)},   {"g", uniform(dice, 9.7, 9.9)},   {"external", 0},
          {"F", uniform(dice, -3000, 3000)}};
}

class Bicycles {
 public:
  Bicycles() : mechanism_(open_mechanism("bicycle")), maker_(mechanism_), batch_(mechanism_) {}

  const MechanismBatch& batch() const { return batch_; }
  const ModePrograms& programs() const { return batch_.code()->programs(); }

  /// In the order of the inputs.
  std::vector<double> inputs(const Numbers& numbers) const {
    std::vector<double> result;
    for (const MechanismParameter& p : mechanism_.parameters) result.push_back(numbers.at(p.symbol));
    result.push_back(numbers.at("F"));
    return result;
  }

  /// Of the inputs which are the same for all: who pushes.
  std::vector<bool> pushed_alike() const {
    std::vector<bool> same;
    for (const MechanismParameter& p : mechanism_.parameters) same.push_back(p.symbol == "external");
    same.push_back(false);
    return same;
  }

  /// A load at which a mode begins or ends, as nearly as binary64 has it, or a neighbour; the same where there is none.
  double tie(const Numbers& numbers, Dice& dice) const {
    FrictionProblem problem = exact(numbers);
    problem.load_domain = ForceInterval();
    std::vector<double> ends;
    for (const ConsistentMode& found : modes_of(problem, std::nullopt).consistent) {
      for (const auto& end : {found.solutions.loads.lower(), found.solutions.loads.upper()}) {
        if (end && std::isfinite(nearest_binary64(*end))) ends.push_back(nearest_binary64(*end));
      }
    }
    if (ends.empty()) return numbers.at("F");
    const double end = ends[static_cast<std::size_t>(dice.number(0, static_cast<int>(ends.size()) - 1))];
    return dice.chance(2) ? end : std::nextafter(end, dice.chance(2) ? HUGE_VAL : -HUGE_VAL);
  }

  std::vector<ModeAt> kernel(const Numbers& numbers) const {
    std::vector<ModeAt> result(batch_.modes().size(), ModeAt::inconsistent);
    const FrictionProblem problem = exact(numbers);
    for (const ConsistentMode& found : ModeSolver(problem, to_rational(numbers.at("F"))).consistent()) {
      const auto place = std::find(batch_.modes().begin(), batch_.modes().end(), found.mode) - batch_.modes().begin();
      result[static_cast<std::size_t>(place)] = found.solutions.strict ? ModeAt::strict : ModeAt::boundary;
    }
    return result;
  }

 private:
  FrictionProblem exact(const Numbers& numbers) const {
    MechanismValues values = default_values(mechanism_);
    for (std::size_t i = 0; i < values.parameters.size(); ++i) {
      values.parameters[i] = to_rational(numbers.at(mechanism_.parameters[i].symbol));
    }
    values.given.assign(values.parameters.size(), true);
    return without_equations(maker_.problem(values));
  }

  Mechanism mechanism_;
  ProblemMaker maker_;
  MechanismBatch batch_;
};

/// Blocks of bicycles whose inputs have the same ranges, which are those of all; the first says what results to expect.
struct Blocks {
  const Bicycles& bicycles;
  BlockCode code;
  BlockModes modes;

  explicit Blocks(const Bicycles& given) : bicycles(given), code(given.programs(), given.pushed_alike()), modes(code) {}

  void learn(const std::vector<Numbers>& first, const std::vector<Numbers>& others) {
    std::vector<SharedRange> ranges(bicycles.programs().inputs(), SharedRange{HUGE_VAL, -HUGE_VAL, 0});
    for (const auto* some : {&first, &others}) {
      for (const Numbers& bicycle : *some) {
        const std::vector<double> inputs = bicycles.inputs(bicycle);
        for (std::size_t i = 0; i < inputs.size(); ++i) {
          ranges[i].lower = std::min(ranges[i].lower, inputs[i]);
          ranges[i].upper = std::max(ranges[i].upper, inputs[i]);
        }
      }
    }
    modes.set_ranges(ranges);
    fill(first);
    modes.see_results();
    modes.find_bounds();
  }

  /// How many are decided, each as the kernel does.
  std::size_t decided(const std::vector<Numbers>& points) {
    fill(points);
    BlockAnswers answers;
    modes.decide(answers);
    std::size_t count = 0;
    for (std::size_t point = 0; point < block_points; ++point) {
      if (answers.left[point] < 0) continue;
      ++count;
      const std::vector<ModeAt> expected = bicycles.kernel(points[point]);
      std::size_t different = 0;
      for (std::size_t mode = 0; mode < expected.size(); ++mode) {
        const bool fails = (answers.inconsistent[mode / 64][point] >> (mode % 64) & 1U) != 0;
        different += expected[mode] == (fails ? ModeAt::inconsistent : ModeAt::strict) ? 0 : 1;
      }
      CHECK(different == 0);
    }
    return count;
  }

 private:
  void fill(const std::vector<Numbers>& points) {
    REQUIRE(points.size() == block_points);
    for (std::size_t point = 0; point < block_points; ++point) {
      const std::vector<double> inputs = bicycles.inputs(points[point]);
      for (std::size_t i = 0; i < inputs.size(); ++i) modes.input(i)[point] = inputs[i];
    }
  }
};

template <class Make>
std::vector<Numbers> block_of(const Make& make) {
  std::vector<Numbers> points;
  for (std::size_t i = 0; i < block_points; ++i) points.push_back(make());
  return points;
}

}  // namespace

TEST_CASE("blocks decide bicycles that may lift, all of whose numbers vary, and not where two modes meet") {
  const Bicycles bicycles;
  Blocks blocks(bicycles);
  Dice dice(41, 1);
  for (int round = 0; round < 4; ++round) {
    const auto first = block_of([&] { return usual(dice); }), others = block_of([&] { return usual(dice); });
    const auto ties = block_of([&] {
      Numbers bicycle = usual(dice);
      bicycle["F"] = bicycles.tie(bicycle, dice);
      return bicycle;
    });
    blocks.learn(first, ties);
    REQUIRE(blocks.modes.able());
    CHECK(blocks.decided(first) > 50);
    CHECK(blocks.decided(others) > 40);  // some are outside of the ranges
    CHECK(blocks.decided(ties) < 8);
  }
}

TEST_CASE("a bicycle whose results are not like those that were seen is left, though its numbers are like theirs") {
  const Bicycles bicycles;
  Blocks blocks(bicycles);
  Dice dice(42, 1);
  std::size_t usual_ones = 0, near_zero = 0, large = 0;
  for (int round = 0; round < 4; ++round) {
    // Axles that meet: the distances are those of the others, their sum is not.
    const auto long_ones = block_of([&] {
      Numbers bicycle = usual(dice);
      bicycle["b2"] = uniform(dice, -1, 2);
      bicycle["b3"] = uniform(dice, 1, 3) - bicycle["b2"];
      return bicycle;
    });
    const auto short_ones = block_of([&] {
      Numbers bicycle = usual(dice);
      bicycle["b2"] = uniform(dice, -0.9, 0.9);
      bicycle["b3"] = std::ldexp(1, -dice.number(20, 60)) - bicycle["b2"];
      if (!(bicycle["b2"] + bicycle["b3"] > 0)) bicycle["b3"] = std::nextafter(-bicycle["b2"], 2);
      bicycle["F"] = bicycles.tie(bicycle, dice);
      return bicycle;
    });
    blocks.learn(long_ones, short_ones);
    REQUIRE(blocks.modes.able());
    usual_ones += blocks.decided(long_ones);
    near_zero += blocks.decided(short_ones);

    // Heavy ones on small wheels, light ones on large ones; then heavy ones on large wheels.
    const auto sized = [&](bool heavy, bool big) {
      Numbers bicycle = usual(dice);
      for (const char* symbol : {"M", "I1", "I2", "I3", "J", "F"}) bicycle[symbol] *= heavy ? 0x1p20 : 1;
      for (const char* symbol : {"R", "h", "b2", "b3", "r1", "r2", "L"}) bicycle[symbol] *= big ? 0x1p10 : 1;
      return bicycle;
    };
    bool heavy = false;
    const auto either = block_of([&] { return heavy = !heavy, sized(heavy, !heavy); });
    const auto both = block_of([&] {
      Numbers bicycle = sized(true, true);
      bicycle["F"] = bicycles.tie(bicycle, dice);
      return bicycle;
    });
    blocks.learn(either, both);
    if (!blocks.modes.able()) continue;
    usual_ones += blocks.decided(either);
    large += blocks.decided(both);
  }
  CHECK(usual_ones > 200);
  CHECK(near_zero == 0);
  CHECK(large < 64);
}

TEST_CASE("a batch of bicycles that may lift has the kernel's modes, at ties and at sizes far apart") {
  const Bicycles bicycles;
  Dice dice(43, 1);
  std::vector<Numbers> points;
  for (int i = 0; i < 1024; ++i) {
    Numbers bicycle = usual(dice);
    if (i >= 256 && i % 4 == 1) bicycle["F"] = bicycles.tie(bicycle, dice);
    if (i >= 256 && i % 8 == 2) {
      for (auto& [symbol, number] : bicycle) {
        if (symbol != "external") number = std::ldexp(number, dice.number(-40, 40));
      }
      bicycle["F"] = bicycles.tie(bicycle, dice);
    }
    if (i >= 256 && i % 16 == 4) bicycle["I1"] = bicycle["I2"] = 0;  // its rear wheel may spin as it likes
    points.push_back(bicycle);
  }
  std::vector<std::vector<double>> columns(bicycles.programs().inputs());
  const std::vector<bool> same = bicycles.pushed_alike();
  for (const Numbers& bicycle : points) {
    const std::vector<double> inputs = bicycles.inputs(bicycle);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      if (!same[i] || columns[i].empty()) columns[i].push_back(inputs[i]);
    }
  }
  MechanismColumns given{{columns.begin(), columns.end() - 1}, {}, Column(columns.back())};
  const MechanismAnswers answers = bicycles.batch().modes_at(given, Unsure::left);
  std::size_t sure = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (answers.at(i, 0) == ModeAt::unsure) continue;
    ++sure;
    const std::vector<ModeAt> expected = bicycles.kernel(points[i]);
    for (std::size_t mode = 0; mode < expected.size(); ++mode) CHECK(answers.at(i, mode) == expected[mode]);
  }
  CHECK(sure > 650);
  CHECK(sure < 900);
}
