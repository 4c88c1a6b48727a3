// The contacts of a scene before and after its load is applied: the start of a simulation, and what then pushes.
#pragma once

#include "contact/problem/problem.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

struct LoadedContacts {
  ContactProblem problem;  ///< with the load
  /// q without the load; 0 for a mechanism without a load, where everything that pushes is its load
  std::vector<Rational> rest;
};

/// At the scene's load. Throws std::invalid_argument, with a message for people, where the scene gives
/// no load that it could, and where the contacts are none that can be simulated: contacts from rest with one
/// coefficient of friction each, whose Delassus matrix is symmetric; NoValue where a coefficient has no value.
LoadedContacts loaded_contacts(const MechanismScene& scene);

/// As the simulation has them: in binary64.
std::vector<double> rounded(const std::vector<Rational>& numbers);

}  // namespace slipproof
