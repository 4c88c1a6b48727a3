// A bicycle, its road and the force on it, all in one: what the solver, the filter and certify take.
#pragma once

#include <optional>

#include "support/bicycle/bicycle.hpp"

namespace slipproof {

/// A scene at one force in numbers of one type, SI units. Written down by names:
///   const ForcedScene<double> scene{
///       .bicycle = {.M = 94, .R = 0.3, .h = 0.56, .b2 = 0.34, .b3 = 0.68, .I1 = 0.01, .I2 = 0.12, .I3 = 0.2,
///                   .r1 = 0.09, .r2 = 0.036, .L = 0.17, .J = 15.7},
///       .road = {.f = 0.8, .g = 9.81},
///       .F = 300};
template <class T>
struct ForcedScene {
  Bicycle<T> bicycle;
  Road<T> road;
  ForceKind force_kind = ForceKind::internal;
  T F{};
};

template <class T, class U, class Convert>
ForcedScene<U> convert(const ForcedScene<T>& s, const Convert& to) {
  const Bicycle<T>& p = s.bicycle;
  ForcedScene<U> r{.bicycle = {.M = to(p.M),
                               .R = to(p.R),
                               .h = to(p.h),
                               .b2 = to(p.b2),
                               .b3 = to(p.b3),
                               .I1 = to(p.I1),
                               .I2 = to(p.I2),
                               .I3 = to(p.I3),
                               .r1 = to(p.r1),
                               .r2 = to(p.r2),
                               .L = to(p.L),
                               .J = std::nullopt},
                   .road = {to(s.road.f), to(s.road.g)},
                   .force_kind = s.force_kind,
                   .F = to(s.F)};
  if (p.J) r.bicycle.J.emplace(to(*p.J));
  return r;
}

/// The numbers as they are: every binary64 is a rational. Throws NumberError for a NaN or an infinity.
ForcedScene<Rational> to_rational(const ForcedScene<double>& scene);
/// Each number rounded to the nearest binary64.
ForcedScene<double> nearest_binary64(const ForcedScene<Rational>& scene);

}  // namespace slipproof
