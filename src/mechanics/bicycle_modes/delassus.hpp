// The contacts of a bicycle as nonsmooth mechanics writes them: contact accelerations = W lambda + c + d F.
#pragma once

#include <array>
#include <optional>

#include "base/number/rational.hpp"
#include "mechanics/bicycle/bicycle.hpp"

namespace slipproof {

/// lambda = (N2, S2, N3, S3), contact accelerations (gap2, slip2, gap3, slip3); SI units.
struct DelassusForm {
  std::array<std::array<Rational, 4>, 4> W;  ///< the Delassus matrix
  std::array<Rational, 4> free;              ///< c, contact accelerations without contact forces and with F = 0
  std::array<Rational, 4> per_force;         ///< d, what a unit of F adds
};

/// From the raw equations, by elimination; needs J. Nothing where a body without inertia makes them singular.
std::optional<DelassusForm> delassus(const Bicycle<Rational>& bicycle, const Road<Rational>& road, ForceKind kind);

}  // namespace slipproof
