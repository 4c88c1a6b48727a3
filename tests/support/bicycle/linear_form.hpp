// Linear forms in the unknowns of the equations of motion and the force: evaluated on them, the equations give their
// own matrix.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "support/bicycle/equations.hpp"

namespace slipproof {

/// constant + sum of coefficients[i] x_i, where x_0 ... x_10 are the unknowns in their order and x_11 is F.
template <class T>
struct LinearForm {
  std::array<T, unknown_count + 1> coefficients;
  T constant;

  explicit LinearForm(T value = T(0)) : constant(std::move(value)) { coefficients.fill(T(0)); }
  static LinearForm variable(std::size_t i) {
    LinearForm form;
    form.coefficients[i] = T(1);
    return form;
  }
};

template <class T>
LinearForm<T> operator+(LinearForm<T> x, const LinearForm<T>& y) {
  for (std::size_t i = 0; i < x.coefficients.size(); ++i) x.coefficients[i] += y.coefficients[i];
  x.constant += y.constant;
  return x;
}
template <class T>
LinearForm<T> operator*(const T& s, LinearForm<T> x) {
  for (auto& c : x.coefficients) c *= s;
  x.constant *= s;
  return x;
}
template <class T>
LinearForm<T> operator-(const LinearForm<T>& x, const LinearForm<T>& y) {
  LinearForm<T> result = x;
  for (std::size_t i = 0; i < y.coefficients.size(); ++i) result.coefficients[i] -= y.coefficients[i];
  result.constant -= y.constant;
  return result;
}
template <class T>
LinearForm<T> operator-(LinearForm<T> x) {
  return T(-1) * std::move(x);
}

/// The unknowns and the force, as forms.
template <class T>
Unknowns<LinearForm<T>> unknown_forms() {
  const auto x = [](std::size_t i) { return LinearForm<T>::variable(i); };
  return {x(0), x(1), x(2), x(3), x(4), x(5), x(6), x(7), x(8), x(9), x(10)};
}
template <class T>
LinearForm<T> force_form() {
  return LinearForm<T>::variable(unknown_count);
}

/// The eleven equations of a mode: sum of row.coefficients[i] x_i + row.constant = 0, the raw system of
/// proofs/MODEL.md.
template <class T>
std::array<LinearForm<T>, unknown_count> raw_system(const Bicycle<T>& p, const Road<T>& road, ForceKind kind,
                                                    ContactMode mode) {
  const auto u = unknown_forms<T>();
  const auto motion = equations_of_motion(p, road, kind, u, force_form<T>());
  const auto rear = contact_equations(p, road, u, Wheel::rear, mode.rear);
  const auto front = contact_equations(p, road, u, Wheel::front, mode.front);
  return {motion[0], motion[1], motion[2], motion[3], motion[4], motion[5],
          motion[6], rear[0],   rear[1],   front[0],  front[1]};
}

}  // namespace slipproof
