// Numbers of the form alpha + beta F with a symbol F: what every force and acceleration of one bicycle is in its force.
#pragma once

#include "number/rational.hpp"

namespace slipproof {

/// alpha + beta F. A module over T: affine numbers add, and scale by a T; their product is not affine and not offered.
template <class T>
struct Affine {
  T alpha{};
  T beta{};

  Affine() = default;
  Affine(T constant) : alpha(std::move(constant)), beta(0) {}  // NOLINT: a constant is an affine number
  Affine(T constant, T slope) : alpha(std::move(constant)), beta(std::move(slope)) {}

  /// The value at the force F.
  template <class U>
  U at(const U& force) const {
    return U(alpha) + U(beta) * force;
  }
  bool operator==(const Affine&) const = default;
};

template <class T>
Affine<T> operator+(const Affine<T>& x, const Affine<T>& y) {
  return {T(x.alpha + y.alpha), T(x.beta + y.beta)};
}
template <class T>
Affine<T> operator-(const Affine<T>& x, const Affine<T>& y) {
  return {T(x.alpha - y.alpha), T(x.beta - y.beta)};
}
template <class T>
Affine<T> operator-(const Affine<T>& x) {
  return {T(-x.alpha), T(-x.beta)};
}
template <class T>
Affine<T> operator*(const T& s, const Affine<T>& x) {
  return {T(s * x.alpha), T(s * x.beta)};
}

}  // namespace slipproof
