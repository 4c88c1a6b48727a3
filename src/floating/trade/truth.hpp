// The exact answer to a scene, and how badly conditioned it is.
#pragma once

#include "floating/filter/filter.hpp"

namespace slipproof {

/// The quantities whose errors are measured: the acceleration, then the forces.
inline constexpr std::array judged_quantities{Quantity::a, Quantity::S2, Quantity::S3, Quantity::N2, Quantity::N3};
template <class T>
using JudgedValues = std::array<T, judged_quantities.size()>;

struct Truth {
  ConsistentModes modes;
  /// The mode, where one alone is consistent and it is regular: then also
  std::optional<ContactMode> only;
  JudgedValues<Rational> values;  ///< of its motion
  /// Of the numerator and the denominator of each value, the sum of |monomials| over |sum of monomials|: by how much
  /// roundings of the inputs and of the operations are magnified, at most. Infinite for a value that is 0.
  JudgedValues<double> conditions{};
};

Truth truth_of(const ForcedScene<Rational>& scene);

/// The quantities of a motion that is regular.
JudgedValues<Rational> exact_values(const ForcedScene<Rational>& scene, ContactMode mode);

}  // namespace slipproof
