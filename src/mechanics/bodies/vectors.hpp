// Vectors in the plane and in space with symbolic coordinates.
#pragma once

#include "mechanics/mechanism/algebra.hpp"
#include "mechanics/mechanism/mechanism.hpp"

namespace slipproof::bodies_in_motion {

/// Sums and products without what says nothing. All divisors that a file writes must not be 0 (derive_mechanism() sees
/// to it), so that 0 times a quotient is 0.
inline bool has_a_value(const Expression&) {
  return true;
}
inline Expression plus(const Expression& x, const Expression& y) {
  return sum_of(x, y, has_a_value);
}
inline Expression minus(const Expression& x, const Expression& y) {
  return difference_of(x, y, has_a_value);
}
inline Expression times(const Expression& x, const Expression& y) {
  return product_of(x, y, has_a_value);
}
inline Expression over(const Expression& x, const Expression& y) {
  return is_literal_zero(x) ? x : quotient_of(x, y);
}

/// In the axes of the scene or of a body. In the plane z is the literal 0, and so is all that follows from it; turns
/// have only a z then.
struct SceneVector {
  Expression x = zero_literal(), y = zero_literal(), z = zero_literal();

  const Expression& operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

inline SceneVector operator+(const SceneVector& a, const SceneVector& b) {
  return {plus(a.x, b.x), plus(a.y, b.y), plus(a.z, b.z)};
}
inline SceneVector operator-(const SceneVector& a, const SceneVector& b) {
  return {minus(a.x, b.x), minus(a.y, b.y), minus(a.z, b.z)};
}
inline SceneVector operator*(const Expression& factor, const SceneVector& a) {
  return {times(factor, a.x), times(factor, a.y), times(factor, a.z)};
}
inline SceneVector operator*(const SceneVector& a, const Expression& factor) {
  return {times(a.x, factor), times(a.y, factor), times(a.z, factor)};
}
inline SceneVector operator/(const SceneVector& a, const Expression& divisor) {
  return {over(a.x, divisor), over(a.y, divisor), over(a.z, divisor)};
}
inline SceneVector operator-(const SceneVector& a) {
  return {negative_of(a.x), negative_of(a.y), negative_of(a.z)};
}
inline Expression dot(const SceneVector& a, const SceneVector& b) {
  return plus(plus(times(a.x, b.x), times(a.y, b.y)), times(a.z, b.z));
}
inline bool is_literal_zero(const SceneVector& a) {
  return slipproof::is_literal_zero(a.x) && slipproof::is_literal_zero(a.y) && slipproof::is_literal_zero(a.z);
}
/// The axis x, y or z.
inline SceneVector axis(std::size_t index) {
  const auto one_at = [&](std::size_t i) { return i == index ? make_number(1) : zero_literal(); };
  return {one_at(0), one_at(1), one_at(2)};
}
/// b turned by right angles about the axes of a: how a point at b moves when a is the spin.
inline SceneVector cross(const SceneVector& a, const SceneVector& b) {
  const Expression none = zero_literal();
  return a.x * SceneVector{none, negative_of(b.z), b.y} + a.y * SceneVector{b.z, none, negative_of(b.x)} +
         a.z * SceneVector{negative_of(b.y), b.x, none};
}
/// The same product of an arm and a force, written as one writes moments.
inline SceneVector moment(const SceneVector& arm, const SceneVector& force) {
  const auto part = [&](std::size_t i, std::size_t j) {
    return minus(times(arm[i], force[j]), times(arm[j], force[i]));
  };
  return {part(1, 2), part(2, 0), part(0, 1)};
}

}  // namespace slipproof::bodies_in_motion
