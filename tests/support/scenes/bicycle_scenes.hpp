// RandomBicycles in numbers as scenes of the mechanism `bicycle`.
#pragma once

#include <optional>

#include "contact/simulation/loaded_contacts.hpp"
#include "support/bicycle/bicycle_motions.hpp"

namespace slipproof::test {

inline MechanismScene scene_of(const Bicycle<Rational>& bicycle, const Road<Rational>& road, ForceKind kind,
                               std::optional<Rational> F = {}) {
  return {"a bicycle", bicycle_mechanism(), bicycle_values(bicycle, road, kind), std::move(F), {}};
}

/// Its two contacts at a force.
inline ContactProblem contacts_of(const Bicycle<Rational>& bicycle, const Road<Rational>& road, ForceKind kind,
                                  const Rational& F) {
  return loaded_contacts(scene_of(bicycle, road, kind, F)).problem;
}

}  // namespace slipproof::test
