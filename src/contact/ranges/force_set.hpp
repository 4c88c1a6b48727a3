// The forces that a contact's law allows at velocities near given ones.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// A superset of them, which is a cone: 0; or r_N >= 0 and r_T = -mu r_N e with e near `slip`; or |r_T| <= mu r_N.
struct ForceSet {
  enum class Kind : std::uint8_t { none, ray, cone };
  Kind kind = Kind::none;
  Rational mu;
  std::vector<Rational> slip;  ///< direction of slip for a ray, a unit vector; empty without friction
  Rational spread;             ///< for a ray: upper bound on |r_T + mu r_N slip| / r_N

  /// An upper bound on -z . r / r_N over its forces, at least 0: what z lacks of the dual cone.
  Rational lack(std::span<const Rational> z) const;
};

/// For each contact, the set of forces that the law allows at velocities within `change` > 0 of `w` in each component.
/// The law must be Coulomb's or the associated one.
std::vector<ForceSet> force_sets(const MixedProblem& problem, std::span<const Rational> w, double change);

}  // namespace slipproof
