// Numbers of the form alpha + beta F with a symbol F: what every force and acceleration of one bicycle is in its force.
#pragma once

#include <utility>

#include "base/number/rational.hpp"

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

// By value where the operand's own memory can hold the result.
template <class T>
Affine<T> operator+(Affine<T> x, const Affine<T>& y) {
  x.alpha = std::move(x.alpha) + y.alpha;
  x.beta = std::move(x.beta) + y.beta;
  return x;
}
template <class T>
Affine<T> operator-(Affine<T> x, const Affine<T>& y) {
  x.alpha = std::move(x.alpha) - y.alpha;
  x.beta = std::move(x.beta) - y.beta;
  return x;
}
template <class T>
Affine<T> operator-(Affine<T> x) {
  x.alpha = -std::move(x.alpha);
  x.beta = -std::move(x.beta);
  return x;
}
template <class T>
Affine<T> operator*(const T& s, const Affine<T>& x) {
  return {T(s * x.alpha), T(s * x.beta)};
}

}  // namespace slipproof
