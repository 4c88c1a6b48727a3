#include "floating/trade/workload.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/number/binary64.hpp"
#include "mechanics/scene/bicycle_scene.hpp"

namespace slipproof {

namespace {

struct DrawnNumber {
  std::string_view symbol;
  double low, high;
};
constexpr std::array<DrawnNumber, 12> drawn_numbers{{{"M", 60, 120},
                                                     {"R", 0.3, 0.36},
                                                     {"h", 0.5, 0.9},
                                                     {"b2", 0.4, 0.6},
                                                     {"b3", 0.4, 0.7},
                                                     {"I1", 0.005, 0.02},
                                                     {"I2", 0.08, 0.2},
                                                     {"I3", 0.08, 0.2},
                                                     {"r1", 0.07, 0.1},
                                                     {"r2", 0.03, 0.1},
                                                     {"L", 0.15, 0.18},
                                                     {"f", 0.3, 1}}};

/// Draws a scene of the bicycle with an internal force and binary64 numbers; the workload then changes it.
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

  /// The value of a parameter in the scene.
  Rational& operator[](std::string_view symbol) { return scene_[bicycle_parameter(symbol)]; }
  Rational& F() { return scene_.back(); }
  const TradeScene& scene() const { return scene_; }
  bool lifts() const { return !scene_[bicycle_parameter("J")].is_zero(); }

  void bicycle() {
    scene_.assign(bicycle_mechanism().parameters.size() + 1, 0);
    for (const auto& [symbol, low, high] : drawn_numbers) (*this)[symbol] = to_rational(uniform(low, high));
    (*this)["g"] = to_rational(9.81);
    F() = to_rational(uniform(-300, 1500));
  }

  /// A nonzero end of the interval of forces of some mode, if there is one.
  std::optional<Rational> threshold() {
    const std::vector<Rational> ends = TradedMechanism::get(lifts()).thresholds(scene_);
    if (ends.empty()) return std::nullopt;
    return ends[static_cast<std::size_t>(integer(0, static_cast<int>(ends.size()) - 1))];
  }

  /// Sets a force at a relative distance of 2^-bits from a threshold, or on it.
  void at_threshold(std::optional<int> bits) {
    std::optional<Rational> end;
    while (!end) {
      bicycle();
      end = threshold();
    }
    F() = bits ? beside(*end, *bits) : *end;
  }

  /// The scenes of section 3 of the paper: M = 1, mu = 1, b2 = b3 = b, P = F, with b near a value at which something
  /// vanishes. Half of the forces are near a threshold.
  void reduced(Rational (*b)(SceneDraw&)) {
    bicycle();
    SceneDraw& s = *this;
    s["M"] = s["r1"] = s["r2"] = 1;
    s["I1"] = 0;
    s["L"] = s["R"];
    const Rational near = b(s);
    s["b2"] = s["b3"] = beside(near, integer(20, 45));
    F() = to_rational(uniform(0, 20));
    if (const auto end = coin() ? threshold() : std::nullopt) F() = beside(*end, integer(20, 45));
  }

 private:
  std::mt19937_64 engine_;
  TradeScene scene_;
};

constexpr std::array<std::string_view, 3> inertias{"I1", "I2", "I3"};

/// M1 = 1 + M2 of section 3, where I1 = 0 and M = 1.
Rational M1(SceneDraw& s) {
  return 1 + s["I2"] / (s["R"] * s["R"]);
}
/// b1, where q = 2 b - f h / M1 vanishes.
Rational b1(SceneDraw& s) {
  return s["f"] * s["h"] / (2 * M1(s));
}
/// Where eta = b - f h vanishes.
Rational no_eta(SceneDraw& s) {
  return s["f"] * s["h"];
}
/// Where 2 eta = f (1 + 2 M2) R.
Rational no_xi4_denominator(SceneDraw& s) {
  return no_eta(s) + s["f"] * (2 * M1(s) - 1) * s["R"] / 2;
}

void scaled_inertias(SceneDraw& s) {
  s.bicycle();
  const Rational factor = power_of_two(s.integer(-996, 996));  // 10^-300 ... 10^300
  for (const auto inertia : inertias) s[inertia] *= factor;
}

void subnormal(SceneDraw& s) {
  const auto tiny = [&] { return to_rational(std::ldexp(s.uniform(1, 2), s.integer(-1074, -1023))); };
  s.bicycle();
  s.F() = s.sign() * tiny();
  for (const auto inertia : inertias) {
    if (s.coin()) s[inertia] = tiny();
  }
}

using Maker = std::function<void(SceneDraw&)>;

std::vector<std::pair<TradeWorkload, Maker>> makers() {
  const auto with_friction_times = [](int sign) {
    return [sign](SceneDraw& s) {
      s.bicycle();
      s["f"] *= power_of_two(sign * s.integer(10, 300));
    };
  };
  const auto lifting = [](SceneDraw& s) {
    s.bicycle();
    s["J"] = to_rational(s.uniform(8, 20));
  };
  std::vector<std::pair<TradeWorkload, Maker>> all{{{"typical", {}}, &SceneDraw::bicycle},
                                                   {{"typical, wheels may lift", {}}, lifting}};
  for (int bits = 10; bits <= 200; bits += 10) {
    all.push_back({{fmt::format("threshold 2^-{}", bits), bits}, [bits](SceneDraw& s) { s.at_threshold(bits); }});
  }
  all.push_back({{"threshold exactly", {}}, [](SceneDraw& s) { s.at_threshold({}); }});
  all.push_back({{"b near b1, q near 0", {}}, [](SceneDraw& s) { s.reduced(b1); }});
  all.push_back({{"eta near 0", {}}, [](SceneDraw& s) { s.reduced(no_eta); }});
  all.push_back({{"2 eta near f (1 + 2 M2) R", {}}, [](SceneDraw& s) { s.reduced(no_xi4_denominator); }});
  all.push_back({{"mass ratio 1e-300 to 1e300", {}}, scaled_inertias});
  all.push_back({{"f towards 0", {}}, with_friction_times(-1)});
  all.push_back({{"f towards infinity", {}}, with_friction_times(1)});
  all.push_back({{"subnormals", {}}, subnormal});
  return all;
}

}  // namespace

std::size_t Workloads::size() {
  return makers().size();
}

Workload Workloads::make(std::size_t index, std::size_t piece) const {
  const auto [workload, maker] = makers().at(index);
  SceneDraw draw(seed * 1000003 + piece * size() + index);
  Workload result{workload, nullptr, {}};
  for (std::size_t left = std::min(piece_size, count - piece * piece_size); left > 0; --left) {
    maker(draw);
    result.scenes.push_back(draw.scene());
  }
  result.mechanism = &TradedMechanism::get(draw.lifts());
  return result;
}

}  // namespace slipproof
