// The contacts of a scene before and after its load is applied: the start of a simulation, and what then pushes.
#pragma once

#include "contact/problem/problem.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

struct LoadedContacts {
  ContactProblem problem;  ///< the problem, with the load
  /// q without the load; 0 for a mechanism without a load, where everything that pushes is its load
  std::vector<Rational> rest;
};

/// The contacts of a scene at its load. Throws std::invalid_argument, with a message for users, if the scene lacks a
/// load, or if its contacts cannot be simulated; these must start from rest, have one coefficient of friction each, and
/// a symmetric Delassus matrix. Throws NoValue if a coefficient has no value.
LoadedContacts loaded_contacts(const MechanismScene& scene);

/// Numbers rounded to binary64, as the simulation uses them.
std::vector<double> rounded(const std::vector<Rational>& numbers);

}  // namespace slipproof
