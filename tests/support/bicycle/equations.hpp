// The mechanics: the equations of proofs/MODEL.md, once, as residuals that vanish on every motion. Written over the
// number type T of the parameters and the type U of the unknowns: with U = T they judge a motion, with U a linear form
// they give the matrix of the system.
#pragma once

#include <array>

#include "support/bicycle/bicycle.hpp"
#include "support/bicycle/contact_mode.hpp"

namespace slipproof {

/// The unknowns of proofs/MODEL.md: accelerations of C and of the bodies, chain tension, forces on the wheels.
template <class U>
struct Unknowns {
  U a, a_y, phi, eps1, eps2, eps3, T, S2, S3, N2, N3;
};
inline constexpr std::size_t unknown_count = 11;

/// Equations of motion and the unstretchable chain: seven residuals. Without J its term is absent, which is right only
/// where phi = 0.
template <class T, class U>
std::array<U, 7> equations_of_motion(const Bicycle<T>& p, const Road<T>& road, ForceKind kind, const Unknowns<U>& u,
                                     const U& F) {
  const U tangential = u.S2 + u.S3;
  U along = p.M * u.a - tangential;
  U pitch = p.I1 * u.eps1 + p.I2 * u.eps2 + p.I3 * u.eps3 - p.b2 * u.N2 + p.b3 * u.N3 + T(p.h + p.R) * tangential;
  if (p.J) pitch = pitch + *p.J * u.phi;
  if (kind == ForceKind::external) {
    along = along + F;
    pitch = pitch - T(p.L + p.h) * F;
  }
  return {along,
          p.M * u.a_y - U(T(p.M * road.g)) + u.N2 + u.N3,
          pitch,
          p.I1 * u.eps1 - p.L * F - p.r1 * u.T,
          p.I2 * u.eps2 + p.R * u.S2 + p.r2 * u.T,
          p.I3 * u.eps3 + p.R * u.S3,
          p.r1 * (u.eps1 - u.phi) - p.r2 * (u.eps2 - u.phi)};
}

/// Acceleration with which the wheel leaves the road, m/s^2, up positive.
template <class T, class U>
U gap(const Bicycle<T>& p, const Unknowns<U>& u, Wheel wheel) {
  return wheel == Wheel::rear ? p.b2 * u.phi - u.a_y : U(T(0)) - u.a_y - p.b3 * u.phi;
}

/// Tangential acceleration of the contact point, m/s^2: the paper's a_j.
template <class T, class U>
U slip(const Bicycle<T>& p, const Unknowns<U>& u, Wheel wheel) {
  return u.a - p.h * u.phi - p.R * (wheel == Wheel::rear ? u.eps2 : u.eps3);
}

/// The quantities of a motion from the unknowns.
template <class T, class U>
Motion<U> motion_of(const Bicycle<T>& p, const Unknowns<U>& u) {
  return {{u.a, u.a_y, u.phi, u.eps2, u.eps3, u.S2, u.S3, u.N2, u.N3, gap(p, u, Wheel::rear), gap(p, u, Wheel::front),
           slip(p, u, Wheel::rear), slip(p, u, Wheel::front)}};
}

/// The two equations of a wheel's contact state, as residuals.
template <class T, class U>
std::array<U, 2> contact_equations(const Bicycle<T>& p, const Road<T>& road, const Unknowns<U>& u, Wheel wheel,
                                   WheelState state) {
  const U& N = wheel == Wheel::rear ? u.N2 : u.N3;
  const U& S = wheel == Wheel::rear ? u.S2 : u.S3;
  switch (state) {
    case WheelState::stick:
      return {gap(p, u, wheel), slip(p, u, wheel)};
    case WheelState::slip_forward:
      return {gap(p, u, wheel), S + road.f * N};
    case WheelState::slip_backward:
      return {gap(p, u, wheel), S - road.f * N};
    default:
      return {N, S};
  }
}

}  // namespace slipproof
