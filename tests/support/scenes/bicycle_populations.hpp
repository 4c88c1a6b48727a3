// RandomBicycles for holding binary64 against the exact solver: the usual, the extreme and the malicious.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "base/number/binary64.hpp"
#include "support/bicycle/forced_scene.hpp"
#include "support/scenes/force_oracle.hpp"

namespace slipproof::test {

enum class Population {
  bicycles,   ///< bicycles that one may meet
  wide,       ///< every parameter over six decades, h, L, b2 of any sign
  extreme,    ///< every parameter over the whole range of binary64, subnormals too
  fractions,  ///< small fractions, which binary64 can only round, and ties
  singular    ///< a few ulp from where a mode becomes singular, or there
};
inline constexpr int population_count = 5;

class RandomBicycles {
 public:
  explicit RandomBicycles(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t next() { return engine_(); }
  /// In [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  double log_uniform(double low, double high) { return low * std::pow(high / low, uniform()); }
  bool coin() { return engine_() >> 63 != 0; }
  double signed_log(double low, double high) { return (coin() ? 1 : -1) * log_uniform(low, high); }
  double exponent_uniform(int low, int high) { return std::ldexp(uniform(1, 2), low + int(uniform() * (high - low))); }

  /// A bicycle and a road, F = 0.
  ForcedScene<Rational> scene(Population population) {
    const bool detachment = coin();
    ForcedScene<Rational> s = population == Population::fractions ? fractions() : to_rational(binary(population));
    s.force_kind = coin() ? ForceKind::internal : ForceKind::external;
    if (!detachment) s.bicycle.J.reset();
    return s;
  }

  /// A bicycle that one may meet, with a rider's force, as binary64.
  ForcedScene<double> typical() {
    ForcedScene<double> s = binary(Population::bicycles);
    s.force_kind = coin() ? ForceKind::internal : ForceKind::external;
    if (coin()) s.bicycle.J.reset();
    s.F = signed_log(1, 3000);
    return s;
  }

  /// Forces of all sizes and, unless the population is tame, near the ends of the modes' intervals.
  std::vector<double> forces(const ForceOracle& oracle, std::size_t count, bool adversarial) {
    std::vector<double> result;
    while (result.size() < count) {
      if (adversarial && !oracle.ends().empty() && uniform() < 0.9) {
        double F = oracle.ends()[engine_() % oracle.ends().size()];
        if (coin()) {
          for (auto ulps = engine_() % 5; ulps > 0; --ulps) F = std::nextafter(F, coin() ? HUGE_VAL : -HUGE_VAL);
        } else {
          F += F * std::ldexp(uniform(-1, 1), -int(engine_() % 60));
        }
        if (std::isfinite(F)) result.push_back(F);
      } else if (uniform() < 0.02) {
        result.push_back(coin() ? 0 : signed_log(1e-320, 1e-290));
      } else {
        result.push_back(signed_log(1e-3, 1e5));
      }
    }
    return result;
  }

 private:
  ForcedScene<double> binary(Population population) {
    if (population == Population::bicycles) {
      return {{.M = uniform(50, 150),
               .R = uniform(0.2, 0.4),
               .h = uniform(-0.1, 0.9),
               .b2 = uniform(0.3, 0.8),
               .b3 = uniform(0.3, 0.8),
               .I1 = uniform(0.002, 0.03),
               .I2 = uniform(0.05, 0.3),
               .I3 = uniform(0.05, 0.3),
               .r1 = uniform(0.05, 0.12),
               .r2 = uniform(0.02, 0.12),
               .L = uniform(0.14, 0.2),
               .J = uniform(5, 30)},
              {uniform(0.05, 1.5), uniform(9.7, 9.9)},
              ForceKind::internal,
              0};
    }
    if (population == Population::singular) return near_singular();
    const auto positive = [&] {
      return population == Population::wide ? log_uniform(1e-3, 1e3) : exponent_uniform(-1074, 1023);
    };
    const auto any = [&] { return coin() ? positive() : -positive(); };
    ForcedScene<double> s{{.M = positive(),
                           .R = positive(),
                           .h = positive(),
                           .b2 = positive(),
                           .b3 = positive(),
                           .I1 = coin() ? 0 : positive(),
                           .I2 = positive(),
                           .I3 = positive(),
                           .r1 = positive(),
                           .r2 = positive(),
                           .L = any(),
                           .J = positive()},
                          {positive(), positive()},
                          ForceKind::internal,
                          0};
    if (coin()) s.bicycle.h = -s.bicycle.R * uniform();
    if (coin()) s.bicycle.b2 = -s.bicycle.b3 * uniform();
    if (!(s.bicycle.b2 + s.bicycle.b3 > 0)) s.bicycle.b2 = s.bicycle.b3;
    return s;
  }

  /// b2 = b3 near f h / (2 M1), where three thresholds of the paper meet, in section 3's form or not quite.
  ForcedScene<double> near_singular() {
    ForcedScene<double> s = binary(Population::bicycles);
    Bicycle<double>& p = s.bicycle;
    p.h = uniform(0.2, 0.9);
    if (coin()) p.r2 = p.r1;
    if (coin()) p.I1 = 0;
    if (coin()) {  // so few bits that b = b1 holds exactly
      p.M = p.R = 1;
      p.h = double(1 + engine_() % 8);
      p.I2 = p.I3 = 1;
      p.I1 = 0;
      s.road.f = double(1 + engine_() % 8) / 2;
    }
    const double M1 = 1 + (p.I1 + p.I2) / (p.M * p.R * p.R);
    p.b2 = p.b3 = s.road.f * p.h / (2 * M1);
    for (auto ulps = engine_() % 4; ulps > 0; --ulps) p.b2 = p.b3 = std::nextafter(p.b2, coin() ? 0 : 10);
    return s;
  }

  Rational fraction(int low, int high, int denominator) {
    const auto span = static_cast<std::uint64_t>(high - low + 1);
    return Rational(low + static_cast<int>(engine_() % span),
                    1 + static_cast<int>(engine_() % static_cast<std::uint64_t>(denominator)));
  }

  ForcedScene<Rational> fractions() {
    const auto positive = [&] { return fraction(1, 12, 10); };
    Bicycle<Rational> p{.M = positive(),
                        .R = positive(),
                        .h = positive(),
                        .b2 = positive(),
                        .b3 = positive(),
                        .I1 = fraction(0, 3, 10),
                        .I2 = positive(),
                        .I3 = positive(),
                        .r1 = positive(),
                        .r2 = positive(),
                        .L = fraction(-12, 12, 10),
                        .J = positive()};
    p.h -= p.R * Rational(engine_() % 2);
    return {p, {fraction(0, 12, 10), positive()}, ForceKind::internal, 0};
  }

  std::mt19937_64 engine_;
};

}  // namespace slipproof::test
