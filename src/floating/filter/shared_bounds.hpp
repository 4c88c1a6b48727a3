// Error bounds for many scenes at once: those of the scene that has the largest magnitude of each number.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "floating/filter/bounds.hpp"
#include "floating/filter/mode_status.hpp"

namespace slipproof {

/// The magnitude of Tracked alone. It grows with every input, in binary64 too, as rounding is monotone.
struct Magnitude {
  double size = 0;

  Magnitude() = default;
  explicit Magnitude(int constant) : size(std::fabs(double(constant))) {}
  static Magnitude input(double x) {
    Magnitude m;
    m.size = std::fabs(x);
    return m;
  }

  double error() const { return size * (error_roundings * unit_roundoff) + underflow_error; }

  friend Magnitude operator+(Magnitude x, Magnitude y) { return input(x.size + y.size); }
  friend Magnitude operator-(Magnitude x, Magnitude y) { return input(x.size + y.size); }
  friend Magnitude operator*(Magnitude x, Magnitude y) { return input(x.size * y.size); }
  friend Magnitude operator-(Magnitude x) { return x; }
};

/// Bounds for all scenes that are no larger in any number than one. Costs about as much as that scene.
struct SharedBounds {
  double A = 0, I3 = 0;
  /// For the determinant of a mode and all its conditions the largest, as all of them are far from 0 nearly always.
  std::array<double, 16> modes{};

  SharedBounds(const ReducedDynamics<Magnitude, Magnitude>& dynamics, bool detachment)
      : A(dynamics.A.error()), I3(dynamics.I3.error()) {
    for (const ContactMode mode : all_modes()) {
      if (!mode.on_road() && !detachment) continue;
      const ReducedMotion<Magnitude, Magnitude> motion(dynamics, mode);
      double& bound = modes[mode.index()] = motion.determinant().error();
      const ConditionList list = condition_list(mode);
      for (std::size_t i = 0; i < static_cast<std::size_t>(list.count); ++i) {
        bound = std::fmax(bound, motion.condition_value(list.items[i]).numerator.error());
      }
    }
  }
};

}  // namespace slipproof
