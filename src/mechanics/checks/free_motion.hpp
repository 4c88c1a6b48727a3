// Inside the checks: a mechanism without its contacts, solved for what contact forces do.
#pragma once

#include <optional>
#include <vector>

#include "mechanics/points/problem.hpp"

namespace slipproof::mechanism_checks {

using Matrix = std::vector<std::vector<Rational>>;

/// One row of a linear system: coefficients . x = each of the right-hand sides.
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
/// In the order of the forces among the unknowns: contacts, friction elements, links.
std::vector<Pairing> pairings(const Mechanism& mechanism, const FrictionProblem& problem);

/// The derivatives of the motions by the forces; nothing where the equations do not determine the accelerations.
std::optional<Matrix> delassus(const Mechanism& mechanism, const FrictionProblem& problem,
                               const std::vector<Pairing>& pairings);

/// The motion without load and without the forces of contacts and friction elements; links hold.
struct FreeMotion {
  std::vector<Rational> gaps;  ///< of each contact
  bool moves = false;          ///< some unknown acceleration is not 0
};
/// Nothing where the equations do not determine it.
std::optional<FreeMotion> free_motion(const Mechanism& mechanism, const FrictionProblem& problem);

/// How a mechanism can move before any contact holds it.
struct Freedom {
  std::size_t degrees = 0;               ///< accelerations that the links leave free
  std::vector<std::size_t> said_before;  ///< links that say what those before them say, at every point that was tried
};

/// By the rank of the links at points of the domain; nothing where no point was found, or where the rank depends on the
/// point.
std::optional<Freedom> freedom(const Mechanism& mechanism);

}  // namespace slipproof::mechanism_checks
