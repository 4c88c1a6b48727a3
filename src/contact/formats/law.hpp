// The laws of contact and friction that solvers solve, one of which is Coulomb's (LAWS.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slipproof {

enum class FrictionLaw : std::uint8_t {
  cone,        ///< Coulomb's: |r_T| <= mu r_N, Euclidean, u_T against r_T where that is an equality
  box,         ///< |r_T1| <= mu r_N and |r_T2| <= mu r_N, each direction for itself
  diamond,     ///< |r_T1| + |r_T2| <= mu r_N, with the largest dissipation
  fixed,       ///< |r_Ti| <= a bound of the problem, each direction for itself, whatever r_N is
  associated,  ///< r in the cone, u in its dual cone, r . u = 0: convex; what slides also opens
  regularised  ///< r_T = -mu r_N f(|u_T| / v_s) u_T / |u_T|: whatever holds creeps
};

/// f of the regularised law.
enum class Regularisation : std::uint8_t {
  linear,  ///< min(s, 1)
  soft     ///< s / sqrt(1 + s^2): |u_T| is replaced by sqrt(u_T^2 + v_s^2)
};

/// A law with what it needs to be stated.
struct ContactLaw {
  FrictionLaw kind = FrictionLaw::cone;
  std::vector<double> bounds;  ///< fixed: >= 0, of each tangential component, by contacts
  double slip_speed = 0;       ///< regularised: v_s > 0
  Regularisation function = Regularisation::linear;
};

/// `friction cone`, `box pyramid |t1| <= mu n, |t2| <= mu n`, `associated law`, ...
std::string_view name(FrictionLaw law);
/// As options, files and certificates call it: `cone`, ...
std::string_view word(FrictionLaw law);
std::string_view word(Regularisation function);
/// By its word; `coulomb` is `cone`, too.
std::optional<FrictionLaw> law_called(std::string_view word);
std::optional<Regularisation> regularisation_called(std::string_view word);
/// `cone, coulomb, box, ...`, for messages.
std::string law_words();

}  // namespace slipproof
