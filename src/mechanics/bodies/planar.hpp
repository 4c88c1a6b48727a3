// Vectors in the plane with symbolic coordinates.
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

struct PlanarVector {
  Expression x, y;
};

inline PlanarVector operator+(const PlanarVector& a, const PlanarVector& b) {
  return {plus(a.x, b.x), plus(a.y, b.y)};
}
inline PlanarVector operator-(const PlanarVector& a, const PlanarVector& b) {
  return {minus(a.x, b.x), minus(a.y, b.y)};
}
inline PlanarVector operator*(const Expression& factor, const PlanarVector& a) {
  return {times(factor, a.x), times(factor, a.y)};
}
inline PlanarVector operator-(const PlanarVector& a) {
  return {negative_of(a.x), negative_of(a.y)};
}
inline Expression dot(const PlanarVector& a, const PlanarVector& b) {
  return plus(times(a.x, b.x), times(a.y, b.y));
}
/// The moment of a force b at the arm a.
inline Expression cross(const PlanarVector& a, const PlanarVector& b) {
  return minus(times(a.x, b.y), times(a.y, b.x));
}
/// Turned by a right angle, counterclockwise.
inline PlanarVector turned(const PlanarVector& a) {
  return {negative_of(a.y), a.x};
}

}  // namespace slipproof::bodies_in_motion
