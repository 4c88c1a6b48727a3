// Vectors, turns and poses in space, in rationals.
#pragma once

#include <array>
#include <optional>

#include "base/number/rational.hpp"

namespace slipproof::imported {

struct Vector {
  Rational x = 0, y = 0, z = 0;

  const Rational& operator[](std::size_t i) const { return i == 0 ? x : i == 1 ? y : z; }
  bool operator==(const Vector&) const = default;
};

inline Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator*(const Rational& s, const Vector& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline Rational dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Columns are the images of the axes.
struct Turn {
  std::array<Vector, 3> axes{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};

  Vector operator()(const Vector& v) const { return v.x * axes[0] + v.y * axes[1] + v.z * axes[2]; }
  Turn operator*(const Turn& other) const {
    return {{(*this)(other.axes[0]), (*this)(other.axes[1]), (*this)(other.axes[2])}};
  }
};

struct Pose {
  Turn turn;
  Vector at;

  Vector operator()(const Vector& v) const { return at + turn(v); }
  Pose operator*(const Pose& other) const { return {turn * other.turn, (*this)(other.at)}; }
};

/// A symmetric matrix: xx, yy, zz, xy, xz, yz.
struct Inertia {
  Rational xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

  /// a . I b
  Rational between(const Vector& a, const Vector& b) const;
};
Inertia operator+(const Inertia& a, const Inertia& b);
/// The inertia in other axes; `turn` gives the old axes in the new ones.
Inertia turned(const Inertia& inertia, const Turn& turn);
/// The inertia of a point mass at r.
Inertia of_point(const Rational& mass, const Vector& r);

/// The rational value of the shortest decimal of a binary64, which recovers a number of up to 15 digits in a file.
/// Throws NumberError for NaN and infinities.
Rational written(double x);
/// The same with 15 digits, for a number that a program computed from the file with an error in the last bit.
Rational computed(double x);

/// The same with 15 places behind the point, where a rounding error stands for 0: a place in metres, computed.
Rational placed(double x);

/// A rational rotation near that of a quaternion (w, x, y, z) of any length but 0. Angles within 5e-6 of right angles,
/// as decimals give them, become exact; others become the simplest rotation within 1e-14. `error` is about the largest
/// deviation in radians, if it exceeds rounding.
struct RationalTurn {
  Turn turn;
  double error = 0;
};
RationalTurn rational_turn(const std::array<double, 4>& quaternion);

/// A vector of length 1 near one of any length but 0, where its own has no rational length.
Vector unit_near(const std::array<double, 3>& v);
/// `direction_of`, or one near it.
Vector unit_of(const Vector& v);
/// The pose itself, or, where its numbers grew beyond what 60 digits hold, one nearby that has short ones (1e-14).
Pose tidy(const Pose& pose);
/// A quaternion (w, x, y, z) of a turn.
std::array<double, 4> quaternion_of(const Turn& turn);

/// The unit vector, if the length is rational and not 0.
std::optional<Vector> direction_of(const Vector& v);

}  // namespace slipproof::imported
