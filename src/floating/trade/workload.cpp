#include "floating/trade/workload.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/number/binary64.hpp"

namespace slipproof {

/// Random scenes with both wheels on the road and an internal force, all numbers binary64.
class SceneDraw {
 public:
  explicit SceneDraw(std::uint64_t seed) : engine_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool coin() { return engine_() >> 63 != 0; }
  Rational sign() { return coin() ? 1 : -1; }
  /// x times 1 + 2^-bits, or 1 - 2^-bits.
  Rational beside(const Rational& x, int bits) { return x * (1 + sign() * power_of_two(-bits)); }

  ForcedScene<Rational> bicycle() {
    const auto in = [&](double low, double high) { return to_rational(uniform(low, high)); };
    ForcedScene<Rational> s;
    s.bicycle = {.M = in(60, 120),
                 .R = in(0.3, 0.36),
                 .h = in(0.5, 0.9),
                 .b2 = in(0.4, 0.6),
                 .b3 = in(0.4, 0.7),
                 .I1 = in(0.005, 0.02),
                 .I2 = in(0.08, 0.2),
                 .I3 = in(0.08, 0.2),
                 .r1 = in(0.07, 0.1),
                 .r2 = in(0.03, 0.1),
                 .L = in(0.15, 0.18),
                 .J = std::nullopt};
    s.road = {in(0.3, 1), to_rational(9.81)};
    s.F = in(-300, 1500);
    return s;
  }

  /// An end, not 0, of the interval of forces of some mode, if there are any.
  std::optional<Rational> threshold(const ForcedScene<Rational>& s) {
    std::vector<Rational> ends;
    const ModeTable table(s.bicycle, s.road, s.force_kind);
    for (const ModeSolution& mode : table.solutions()) {
      for (const auto& end : {mode.closed().lower(), mode.closed().upper()}) {
        if (end && !end->is_zero()) ends.push_back(*end);
      }
    }
    if (ends.empty()) return std::nullopt;
    return ends[static_cast<std::size_t>(integer(0, static_cast<int>(ends.size()) - 1))];
  }

  /// Section 3 of the paper: M = 1, mu = 1, b2 = b3 = b, P = F; b beside a value where something vanishes. Half of the
  /// forces stand beside a threshold.
  ForcedScene<Rational> reduced(Rational (*b)(const ForcedScene<Rational>&)) {
    ForcedScene<Rational> s = bicycle();
    Bicycle<Rational>& p = s.bicycle;
    p.M = p.r1 = p.r2 = 1;
    p.I1 = 0;
    p.L = p.R;
    p.b2 = p.b3 = beside(b(s), integer(20, 45));
    s.F = to_rational(uniform(0, 20));
    if (const auto end = coin() ? threshold(s) : std::nullopt) s.F = beside(*end, integer(20, 45));
    return s;
  }

 private:
  std::mt19937_64 engine_;
};

namespace {

/// A force at a relative distance of 2^-bits from a threshold, or there.
ForcedScene<Rational> at_threshold(SceneDraw& draw, std::optional<int> bits) {
  while (true) {
    ForcedScene<Rational> s = draw.bicycle();
    const auto end = draw.threshold(s);
    if (!end) continue;
    s.F = bits ? draw.beside(*end, *bits) : *end;
    return s;
  }
}

/// M1 = 1 + M2 of section 3, where I1 = 0 and M = 1.
Rational M1(const ForcedScene<Rational>& s) {
  return 1 + s.bicycle.I2 / (s.bicycle.R * s.bicycle.R);
}
/// b1, where q = 2 b - f h / M1 vanishes.
Rational b1(const ForcedScene<Rational>& s) {
  return s.road.f * s.bicycle.h / (2 * M1(s));
}
/// Where eta = b - f h vanishes.
Rational no_eta(const ForcedScene<Rational>& s) {
  return s.road.f * s.bicycle.h;
}
/// Where 2 eta = f (1 + 2 M2) R.
Rational no_xi4_denominator(const ForcedScene<Rational>& s) {
  return no_eta(s) + s.road.f * (2 * M1(s) - 1) * s.bicycle.R / 2;
}

ForcedScene<Rational> scaled_inertias(SceneDraw& draw) {
  ForcedScene<Rational> s = draw.bicycle();
  const Rational factor = power_of_two(draw.integer(-996, 996));  // 10^-300 ... 10^300
  for (Rational* inertia : {&s.bicycle.I1, &s.bicycle.I2, &s.bicycle.I3}) *inertia *= factor;
  return s;
}

ForcedScene<Rational> subnormal(SceneDraw& draw) {
  const auto tiny = [&] { return to_rational(std::ldexp(draw.uniform(1, 2), draw.integer(-1074, -1023))); };
  ForcedScene<Rational> s = draw.bicycle();
  s.F = draw.sign() * tiny();
  for (Rational* inertia : {&s.bicycle.I1, &s.bicycle.I2, &s.bicycle.I3}) {
    if (draw.coin()) *inertia = tiny();
  }
  return s;
}

}  // namespace

Workloads::Workloads(std::size_t count, std::uint64_t seed) : count_(count), seed_(seed) {
  const auto with_friction_times = [](int sign) {
    return [sign](SceneDraw& draw) {
      ForcedScene<Rational> s = draw.bicycle();
      s.road.f *= power_of_two(sign * draw.integer(10, 300));
      return s;
    };
  };
  add({"typical", {}}, [](SceneDraw& draw) { return draw.bicycle(); });
  add({"typical, wheels may lift", {}}, [](SceneDraw& draw) {
    ForcedScene<Rational> s = draw.bicycle();
    s.bicycle.J = to_rational(draw.uniform(8, 20));
    return s;
  });
  for (int bits = 10; bits <= 200; bits += 10) {
    add({fmt::format("threshold 2^-{}", bits), bits}, [bits](SceneDraw& draw) { return at_threshold(draw, bits); });
  }
  add({"threshold exactly", {}}, [](SceneDraw& draw) { return at_threshold(draw, std::nullopt); });
  add({"b near b1, q near 0", {}}, [](SceneDraw& draw) { return draw.reduced(b1); });
  add({"eta near 0", {}}, [](SceneDraw& draw) { return draw.reduced(no_eta); });
  add({"2 eta near f (1 + 2 M2) R", {}}, [](SceneDraw& draw) { return draw.reduced(no_xi4_denominator); });
  add({"mass ratio 1e-300 to 1e300", {}}, scaled_inertias);
  add({"f towards 0", {}}, with_friction_times(-1));
  add({"f towards infinity", {}}, with_friction_times(1));
  add({"subnormals", {}}, subnormal);
}

Workload Workloads::make(std::size_t index, std::size_t piece) const {
  const auto& [workload, maker] = makers_.at(index);
  SceneDraw draw(seed_ * 1000003 + piece * makers_.size() + index);
  Workload result{workload, {}};
  const std::size_t count = std::min(piece_size, count_ - piece * piece_size);
  while (result.scenes.size() < count) result.scenes.push_back(maker(draw));
  return result;
}

}  // namespace slipproof
