// Vectors in space in floating point, for pictures.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace slipproof {

using Vec3 = std::array<double, 3>;

inline Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec3 operator-(const Vec3& a, const Vec3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vec3 operator*(double factor, const Vec3& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}
inline double dot(const Vec3& a, const Vec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Vec3& a) {
  return std::sqrt(dot(a, a));
}
/// Of length 1; 0 for 0.
inline Vec3 direction_of(const Vec3& a) {
  const double size = length(a);
  return size > 0 ? (1 / size) * a : Vec3{0, 0, 0};
}

/// Two directions of length 1 across a direction and each other: first x second is the direction.
struct AcrossDirections {
  Vec3 first, second;
  explicit AcrossDirections(const Vec3& direction) {
    const Vec3 other = std::abs(direction[0]) < 0.6 * length(direction) ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    second = direction_of(cross(direction, other));
    first = direction_of(cross(second, direction));
  }
};

}  // namespace slipproof
