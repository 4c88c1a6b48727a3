#include "contact/imported/space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"
#include "base/number/parse.hpp"
#include "base/number/simplest.hpp"

namespace slipproof::imported {

Rational Inertia::between(const Vector& a, const Vector& b) const {
  return a.x * (xx * b.x + xy * b.y + xz * b.z) + a.y * (xy * b.x + yy * b.y + yz * b.z) +
         a.z * (xz * b.x + yz * b.y + zz * b.z);
}

Inertia operator+(const Inertia& a, const Inertia& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
}

Inertia turned(const Inertia& inertia, const Turn& turn) {
  const auto row = [&](std::size_t i) { return Vector{turn.axes[0][i], turn.axes[1][i], turn.axes[2][i]}; };
  const auto entry = [&](std::size_t i, std::size_t j) { return inertia.between(row(i), row(j)); };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)};
}

Inertia of_point(const Rational& mass, const Vector& r) {
  const Rational all = dot(r, r);
  return {mass * (all - r.x * r.x), mass * (all - r.y * r.y), mass * (all - r.z * r.z),
          -mass * r.x * r.y,        -mass * r.x * r.z,        -mass * r.y * r.z};
}

Rational written(double x) {
  if (!std::isfinite(x)) return to_rational(x);  // throws
  return parse_rational(fmt::format("{}", x));
}

Rational computed(double x) {
  if (!std::isfinite(x)) return to_rational(x);  // throws
  return parse_rational(fmt::format("{:.15g}", x));
}

Rational placed(double x) {
  if (!std::isfinite(x)) return to_rational(x);  // throws
  return parse_rational(fmt::format("{:.15f}", x));
}

RationalTurn rational_turn(const std::array<double, 4>& quaternion) {
  const auto largest = *std::ranges::max_element(quaternion, {}, [](double x) { return std::abs(x); });
  std::array<double, 4> ratios{};
  std::ranges::transform(quaternion, ratios.begin(), [&](double x) { return x / largest; });
  const auto is_right = [](double x) { return std::abs(x - std::round(x)) <= 5e-6; };
  const bool right = std::ranges::all_of(ratios, is_right);
  std::array<Rational, 4> q;
  RationalTurn result;
  for (std::size_t i = 0; i < 4; ++i) {
    if (right || is_right(ratios[i])) {
      q[i] = Rational(static_cast<int>(std::lround(ratios[i])));
    } else {
      const Rational exact = to_rational(ratios[i]), near = Rational(1) / Rational(100'000'000'000'000);
      q[i] = simplest_between(exact - near, exact + near);
    }
    const double off = std::abs(nearest_binary64(q[i]) - ratios[i]);
    if (off > 1e-15) result.error += 2 * off;
  }
  const auto& [w, x, y, z] = q;
  const Rational n = w * w + x * x + y * y + z * z;
  const auto over = [&](const Rational& a, const Rational& b, const Rational& c) {
    return Vector{a / n, b / n, c / n};
  };
  result.turn.axes = {over(w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)),
                      over(2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)),
                      over(2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z)};
  return result;
}

std::array<double, 4> quaternion_of(const Turn& turn) {
  std::array<std::array<double, 3>, 3> m{};  // by rows
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) m[i][j] = nearest_binary64(turn.axes[j][i]);
  }
  // Four ways to the same quaternion: the one with the greatest component loses no digits.
  const std::array<std::array<double, 4>, 4> ways{
      std::array{1 + m[0][0] + m[1][1] + m[2][2], m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]},
      std::array{m[2][1] - m[1][2], 1 + m[0][0] - m[1][1] - m[2][2], m[0][1] + m[1][0], m[0][2] + m[2][0]},
      std::array{m[0][2] - m[2][0], m[0][1] + m[1][0], 1 - m[0][0] + m[1][1] - m[2][2], m[1][2] + m[2][1]},
      std::array{m[1][0] - m[0][1], m[0][2] + m[2][0], m[1][2] + m[2][1], 1 - m[0][0] - m[1][1] + m[2][2]}};
  std::size_t best = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    if (ways[i][i] > ways[best][best]) best = i;
  }
  return ways[best];
}

Vector unit_near(const std::array<double, 3>& v) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  const double z = v[2] / length;
  if (z < -0.5) {  // the turn from z to the opposite one, which is not near half a turn
    const Vector opposite = unit_near({-v[0], -v[1], -v[2]});
    return Rational(-1) * opposite;
  }
  return rational_turn({1 + z, -v[1] / length, v[0] / length, 0}).turn.axes[2];
}

Vector unit_of(const Vector& v) {
  if (const auto exact = direction_of(v)) return *exact;
  return unit_near({nearest_binary64(v.x), nearest_binary64(v.y), nearest_binary64(v.z)});
}

Pose tidy(const Pose& pose) {
  const auto is_long = [](const Vector& v) {
    constexpr std::size_t digits = 60;
    return v.x.str().size() > digits || v.y.str().size() > digits || v.z.str().size() > digits;
  };
  Pose result = pose;
  if (std::ranges::any_of(pose.turn.axes, is_long)) result.turn = rational_turn(quaternion_of(pose.turn)).turn;
  if (is_long(pose.at)) {
    const auto near = [](const Rational& x) { return placed(nearest_binary64(x)); };
    result.at = {near(pose.at.x), near(pose.at.y), near(pose.at.z)};
  }
  return result;
}

std::optional<Vector> direction_of(const Vector& v) {
  const auto length = exact_root(dot(v, v));
  if (!length || length->is_zero()) return std::nullopt;
  return (Rational(1) / *length) * v;
}

}  // namespace slipproof::imported
