// Inside the checks: a mechanism without its contacts, solved for what contact forces do.
#pragma once

#include <optional>
#include <vector>

#include "mechanics/points/problem.hpp"

namespace slipproof::mechanism_checks {

using Matrix = std::vector<std::vector<Rational>>;

/// A row of a linear system with several right-hand sides: coefficients . x = right-hand side, for each.
struct Row {
  std::vector<Rational> coefficients, right;
};
/// The solutions, a column for each right-hand side; nothing unless there is exactly one.
std::optional<Matrix> solve(const std::vector<Row>& rows, std::size_t unknowns);

/// A gap, slip or zero with the force that works along it.
struct Pairing {
  AffineForm motion;
  std::size_t force;  ///< among the unknowns
  std::string name;
  Place place;
};
/// Pairs each force with its acceleration, in the order of the forces among the unknowns: contacts, friction elements,
/// links.
std::vector<Pairing> pairings(const Mechanism& mechanism, const FrictionProblem& problem);

/// The derivatives of the motions by the forces; nothing where the equations do not determine the accelerations.
std::optional<Matrix> delassus(const Mechanism& mechanism, const FrictionProblem& problem,
                               const std::vector<Pairing>& pairings);

/// The motion without load and without the forces of contacts and friction elements; links hold.
struct FreeMotion {
  std::vector<Rational> gaps;  ///< gap accelerations, by contact
  bool moves = false;          ///< some unknown acceleration is not 0
};
/// The motion without contact forces; nothing if the equations do not determine it.
std::optional<FreeMotion> free_motion(const Mechanism& mechanism, const FrictionProblem& problem);

/// The degrees of freedom of a mechanism without contacts.
struct Freedom {
  std::size_t degrees = 0;               ///< accelerations that the links leave free
  std::vector<std::size_t> said_before;  ///< links that say what those before them say, at every point that was tried
};

/// Computes the freedom from the rank of the links at points of the domain. Nothing if no point was found, or if the
/// rank depends on the point.
std::optional<Freedom> freedom(const Mechanism& mechanism);

}  // namespace slipproof::mechanism_checks
