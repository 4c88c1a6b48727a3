// What bounds that scenes share decide, in each kind of vector registers: nothing that they do not cover.
#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <limits>
#include <vector>

#include "floating/filter/lanes.hpp"
#include "floating/filter/size_check.hpp"
#include "floating/filter/vector_kernel.hpp"
#include "support/filter_scenes.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

template <class Test>
void in_all_registers(const Test& test) {
  for (const Registers registers : {Registers::two, Registers::four, Registers::eight}) {
    if (available(registers)) test(registers);
  }
}

/// The numbers of lane_count scenes, one after another.
using NumbersOfScenes = std::vector<LaneNumbers>;

struct CheckSizes {
  template <int width>
  static void run(const NumbersOfScenes& numbers, const Sizes& sizes, std::array<std::int64_t, lane_count>& outside) {
    using V = typename LaneTypes<width>::Numbers;
    for (std::size_t lane = 0; lane < lane_count; lane += width) {
      SizeCheck<V> check(sizes);
      for (const LaneNumbers& number : numbers) check.add(load<V>(&number.of[lane]));
      const BitsOf<V> found = check.outside();
      std::memcpy(&outside[lane], &found, sizeof found);
    }
  }
};

/// The lanes that are outside, bit i for lane i.
unsigned outside(Registers registers, const NumbersOfScenes& numbers, const Sizes& sizes) {
  std::array<std::int64_t, lane_count> found{};
  VectorKernel<CheckSizes>::run(registers, numbers, sizes, found);
  unsigned lanes = 0;
  for (std::size_t lane = 0; lane < lane_count; ++lane) lanes |= unsigned{found[lane] < 0} << lane;
  return lanes;
}

struct DecideShared {
  template <int width>
  static void run(const ForcedScene<LaneNumbers>& scenes, const SharedBounds& bounds,
                  std::array<std::int64_t, lane_count>& sets) {
    using V = typename LaneTypes<width>::Numbers;
    using N = PlainLanes<V>;
    for (std::size_t lane = 0; lane < lane_count; lane += width) {
      const auto s = convert<LaneNumbers, N>(
          scenes, [lane](const LaneNumbers& numbers) { return N::input(load<V>(&numbers.of[lane])); });
      const auto dynamics = reduce<N, N>(s.bicycle, s.road, s.force_kind, s.F, N(1));
      const auto found = decide_lanes<V>(dynamics, s.bicycle.J.has_value(), CommonBounds<V>{bounds});
      std::memcpy(&sets[lane], &found, sizeof found);
    }
  }
};

/// The modes whose conditions hold, or negative where a sign is not beyond its bound; one scene, one number at a time.
int decided_by(const ForcedScene<double>& s, const SharedBounds& bounds) {
  const auto dynamics = tracked_dynamics<Tracked>(s);
  bool sure = dynamics.A.value() > bounds.A && dynamics.I3.value() > bounds.I3;
  int modes = 0;
  for (const ContactMode mode : all_modes()) {
    if (!mode.on_road() && !s.bicycle.J) continue;
    const ReducedMotion<Tracked, Tracked> motion(dynamics, mode);
    const double determinant = motion.determinant().value(), bound = bounds.modes[mode.index()];
    double least = HUGE_VAL;
    for (const Condition& c : conditions(mode)) {
      const double value = motion.condition_value(c).numerator.value();
      least = std::fmin(least, std::signbit(determinant) ? -value : value);
    }
    sure = sure && std::fabs(determinant) > bound && std::fabs(least) > bound;
    if (least > 0) modes |= 1 << mode.index();
  }
  return sure ? modes : -1;
}

}  // namespace

TEST_CASE("a scene is outside by each single number that is as large as its size, of either sign, or none at all") {
  in_all_registers([](Registers registers) {
    for (const std::size_t count : {std::size_t{14}, std::size_t{15}}) {
      Sizes sizes;
      std::vector<double> limits;
      for (std::size_t i = 0; i < count; ++i) {
        limits.push_back(std::ldexp(1 + 0.25 * double(i % 4), int(7 * i) - 40));
        sizes.set(i, limits.back());
      }
      NumbersOfScenes numbers(count);
      for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
          const std::array<double, 4> inside{0, -0.5, 0.999, std::numeric_limits<double>::denorm_min()};
          numbers[i].of[lane] = limits[i] * inside[(i + lane) % 4];
        }
      }
      CHECK(outside(registers, numbers, sizes) == 0);
      for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
          const double was = numbers[i].of[lane];
          for (const double x :
               {limits[i], -limits[i], 1.5 * limits[i], -1e30, HUGE_VAL, -HUGE_VAL, std::nan(""), -std::nan("")}) {
            numbers[i].of[lane] = x;
            CHECK(outside(registers, numbers, sizes) == 1U << lane);
          }
          numbers[i].of[lane] = was;
        }
      }
    }
  });
}

TEST_CASE("bounds that scenes share leave open every sign that is not beyond them, and decide all others") {
  FilterScenes random(69);
  int decided = 0, open = 0;
  for (int i = 0; i < 400; ++i) {
    std::array<ForcedScene<double>, lane_count> scenes;
    for (auto& s : scenes) {
      s = random.typical();
      s.force_kind = ForceKind::internal;
      s.bicycle.J = i % 2 == 0 ? std::optional(10.0) : std::nullopt;
    }
    // One bound as large as the numbers themselves.
    SharedBounds bounds(tracked_dynamics<Magnitude>(scenes[0]), scenes[0].bicycle.J.has_value());
    const std::size_t large = random.next() % 18;
    for (std::size_t k = 0; k < 18; ++k) {
      double& bound = k < 16 ? bounds.modes[k] : k == 16 ? bounds.A : bounds.I3;
      if (k == large) bound *= std::ldexp(1, 30 + int(random.next() % 24));
    }
    auto lanes = convert<double, LaneNumbers>(scenes[0], [](double) { return LaneNumbers(); });
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      std::vector<double> numbers;
      convert<double, double>(scenes[lane], [&](double x) { return numbers.emplace_back(x); });
      std::size_t at = 0;
      lanes = convert<LaneNumbers, LaneNumbers>(lanes, [&](LaneNumbers x) {
        x.of[lane] = numbers[at++];
        return x;
      });
    }
    in_all_registers([&](Registers registers) {
      std::array<std::int64_t, lane_count> sets{};
      VectorKernel<DecideShared>::run(registers, lanes, bounds, sets);
      for (std::size_t k = 0; k < lane_count; ++k) {
        const int expected = decided_by(scenes[k], bounds);
        CHECK((sets[k] < 0) == (expected < 0));
        if (expected >= 0) CHECK(sets[k] == expected);
        ++(expected < 0 ? open : decided);
      }
    });
  }
  CHECK(decided > 1000);
  CHECK(open > 1000);
}
