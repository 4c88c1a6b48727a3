// Contact problems in rational numbers without free unknowns, in any dimension.
#pragma once

#include <optional>

#include "base/algebra/elimination.hpp"
#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// u = W r + q with Coulomb's law (MixedProblem states it); r and u have `dimension` components for each contact, the
/// normal one first. W may be singular and asymmetric.
struct ExactContacts {
  std::size_t dimension = 3;  ///< 1, 2 or 3
  RationalMatrix W;
  std::vector<Rational> q;
  std::vector<Rational> mu;  ///< of each contact, >= 0; in dimension 1 zeros

  std::size_t size() const { return q.size(); }
  std::size_t contacts() const { return mu.size(); }
  std::size_t normal(std::size_t contact) const { return dimension * contact; }
  /// Whether a contact can have tangential forces.
  bool has_friction(std::size_t contact) const { return dimension > 1 && !mu[contact].is_zero(); }
};

/// The same problem in units in which the diagonal of W and the largest constant are near 1. The units are powers of 2,
/// so that nothing is rounded and short numbers stay short.
struct ScaledContacts {
  ExactContacts contacts;
  std::vector<Rational> force_unit, velocity_unit;  ///< of each component: r = force_unit * the scaled r

  explicit ScaledContacts(const ExactContacts& original);
};

/// The same, for products in integers: W = matrix / scale.
struct IntegerContacts {
  Integer scale = 1;
  IntegerMatrix matrix;

  explicit IntegerContacts(const ExactContacts& contacts);
};

}  // namespace slipproof
