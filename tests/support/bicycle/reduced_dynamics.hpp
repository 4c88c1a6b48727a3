// The bicycle's bodies without the contacts, for reduction.hpp.
#pragma once

#include "support/bicycle/bicycle.hpp"

namespace slipproof {

/// numerator / denominator, kept apart: signs need no division, and rings have none.
template <class V, class T>
struct Quotient {
  V numerator;
  T denominator;
};

/// The bodies without the contacts: sprocket, chain and vertical motion eliminated. T is a ring; V is T, or a module
/// over it such as Affine<T>, in which the force is known.
template <class T, class V>
struct ReducedDynamics {
  T M, R, h, b2, b3;
  T I3;
  T weight;    ///< M g
  T A;         ///< r1^2 I0 = I1 r2^2 + I2 r1^2, (2.7)
  T K;         ///< r1^2 times the coupling of eps2 and phi, (r1 - r2) r2 I1; 0 for mu = 1
  T B;         ///< r1^2 times the pitch inertia, J r1^2 + I1 (r1 - r2)^2; unused without J
  T rho;       ///< r1^2
  T fn, fd;    ///< Coulomb coefficient fn / fd, fd > 0
  V thrust;    ///< force along x: 0, external -F
  V drive;     ///< r1^2 times the moment on the rear wheel, r1 r2 L F
  V overturn;  ///< r1^2 times the moment that pitches the frame

  // What several modes need of these.
  T base;                     ///< b2 + b3
  T RR, rho_R, rho_RR;        ///< R^2, rho R, rho R^2
  T hM, b2M, b3M;             ///< h M, b2 M, b3 M
  T b2_weight, b3_weight;     ///< moments of the weight
  T friction_weight;          ///< fn weight
  T KR, K_rho_R, A_rho, hI3;  ///< K R, K rho R, A rho, h I3
  T KR_hA, RB_hK, AB_KK;      ///< K R - h A, R B - h K, A B - K K
  V R_drive;                  ///< R drive
};

/// The force F is given as a V. `road.f` is the numerator of the Coulomb coefficient over `friction_denominator`.
template <class T, class V>
ReducedDynamics<T, V> reduce(const Bicycle<T>& p, const Road<T>& road, ForceKind kind, const V& F,
                             const T& friction_denominator) {
  const T step = p.r1 - p.r2;
  const T rho = p.r1 * p.r1;
  const T arm = p.r1 * p.r2 * p.L;
  const T I1_step = p.I1 * step;
  const bool external = kind == ForceKind::external;
  const T weight = p.M * road.g, rho_R = rho * p.R;
  const T A = p.I1 * p.r2 * p.r2 + p.I2 * rho;
  const T K = I1_step * p.r2, KR = K * p.R;
  const T B = p.J ? T(*p.J * rho + I1_step * step) : T(0);
  const V drive = arm * F;
  return {.M = p.M,
          .R = p.R,
          .h = p.h,
          .b2 = p.b2,
          .b3 = p.b3,
          .I3 = p.I3,
          .weight = weight,
          .A = A,
          .K = K,
          .B = B,
          .rho = rho,
          .fn = road.f,
          .fd = friction_denominator,
          .thrust = external ? V(-F) : V(T(0)),
          .drive = drive,
          .overturn = (external ? T(rho * (p.L + p.h) - arm) : T(-arm)) * F,
          .base = p.b2 + p.b3,
          .RR = p.R * p.R,
          .rho_R = rho_R,
          .rho_RR = rho_R * p.R,
          .hM = p.h * p.M,
          .b2M = p.b2 * p.M,
          .b3M = p.b3 * p.M,
          .b2_weight = p.b2 * weight,
          .b3_weight = p.b3 * weight,
          .friction_weight = road.f * weight,
          .KR = KR,
          .K_rho_R = K * rho_R,
          .A_rho = A * rho,
          .hI3 = p.h * p.I3,
          .KR_hA = KR - p.h * A,
          .RB_hK = p.R * B - p.h * K,
          .AB_KK = A * B - K * K,
          .R_drive = p.R * drive};
}

}  // namespace slipproof
