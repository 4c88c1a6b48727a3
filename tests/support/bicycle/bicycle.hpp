// The parameters of a scene: a bicycle, a road and where the pedal force comes from (shared symbols of the paper).
#pragma once

#include <optional>

#include "base/number/rational.hpp"

namespace slipproof {

/// A vehicle seen from the side. SI units; the domain of each parameter stands beside it.
template <class T>
struct Bicycle {
  T M;   ///< total mass, kg, > 0
  T R;   ///< radius of both wheels, m, > 0
  T h;   ///< height of the centre of mass C above the axles, m, > -R
  T b2;  ///< horizontal distance of C from the rear contact, m
  T b3;  ///< horizontal distance of C from the front contact, m; b2 + b3 > 0
  T I1;  ///< central moment of inertia of the sprocket, kg m^2, >= 0
  T I2;  ///< of the rear wheel, kg m^2, >= 0
  T I3;  ///< of the front wheel, kg m^2, >= 0
  T r1;  ///< radius of the pedal sprocket, m, > 0
  T r2;  ///< radius of the rear sprocket, m, > 0; mu = r2 / r1
  T L;   ///< arm of the pedal below the line O1 O2, m, any
  /// pitch inertia of the frame about C, kg m^2, > 0; absent: no motion with a wheel off the road
  std::optional<T> J = std::nullopt;
};

template <class T>
struct Road {
  T f;  ///< Coulomb coefficient, >= 0
  T g;  ///< gravity, m/s^2, > 0
};

/// Internal: the rider on the bicycle pushes the pedal (Problem 1). External: somebody beside it does (Problem 2).
enum class ForceKind { internal, external };

/// sigma = mu L / R, equation (1.3).
template <class T>
T sigma(const Bicycle<T>& bicycle) {
  return bicycle.r2 * bicycle.L / (bicycle.r1 * bicycle.R);
}

}  // namespace slipproof
